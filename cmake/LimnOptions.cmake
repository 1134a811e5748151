# What every target of ours is compiled with. Link `limn_options` privately.
add_library(limn_options INTERFACE)
target_compile_options(limn_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror
  # Vectors of four doubles go in and out of functions of one and the same build only.
  $<$<CXX_COMPILER_ID:GNU>:-Wno-psabi>
  # When it optimises, GCC 12 takes `"literal" + std::string` for an overlapping copy (GCC bug 105651)
  # and the members of a moved std::variant that are not in use for uninitialised (105562).
  $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-restrict>
  $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-maybe-uninitialized>)

if(LIMN_SANITIZER)
  target_compile_options(limn_options INTERFACE
    -fsanitize=${LIMN_SANITIZER} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  target_link_options(limn_options INTERFACE -fsanitize=${LIMN_SANITIZER})
endif()

if(CMAKE_UNITY_BUILD)
  # Files are compiled several at a time (the presets that are built from nothing do so: it takes a
  # third of the time). GCC then thinks that a .cpp file's own types were a header's.
  target_compile_options(limn_options INTERFACE
    $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
endif()
