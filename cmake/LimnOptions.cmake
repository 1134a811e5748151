# What every target of ours is compiled with. Link `limn_options` privately.
add_library(limn_options INTERFACE)
target_compile_options(limn_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror)

if(LIMN_SANITIZER)
  target_compile_options(limn_options INTERFACE
    -fsanitize=${LIMN_SANITIZER} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  target_link_options(limn_options INTERFACE -fsanitize=${LIMN_SANITIZER})
endif()
