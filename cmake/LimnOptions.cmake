# What every target of ours is compiled with. Link `limn_options` privately.
add_library(limn_options INTERFACE)
target_compile_options(limn_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror
  # Vectors of four doubles go in and out of functions of one and the same build only.
  -Wno-psabi
  # GCC is the judge of style. Clang, which builds for sanitizers and fuzzing, has other ideas of
  # these two, and believes vectors of four doubles to be less aligned than it lays them out.
  $<$<CXX_COMPILER_ID:Clang>:-Wno-sign-conversion>
  $<$<CXX_COMPILER_ID:Clang>:-Wno-shadow>
  $<$<CXX_COMPILER_ID:Clang>:-Wno-string-conversion>
  $<$<CXX_COMPILER_ID:Clang>:-Wno-align-mismatch>
  # When it optimises, GCC 12 takes `"literal" + std::string` for an overlapping copy (GCC bug 105651)
  # and the members of a moved std::variant that are not in use for uninitialised (105562).
  $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-restrict>
  $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-maybe-uninitialized>)

# What people run checks itself: the standard library its indices, the C library its buffers, every
# function its stack, and the loader keeps what it has linked read-only.
if(NOT LIMN_SANITIZER AND CMAKE_BUILD_TYPE STREQUAL "Release")
  set(is_guarded $<NOT:$<BOOL:$<TARGET_PROPERTY:LIMN_TRUSTS_ITS_INDICES>>>)
  target_compile_definitions(limn_options INTERFACE
    $<${is_guarded}:_GLIBCXX_ASSERTIONS> _FORTIFY_SOURCE=2)
  target_compile_options(limn_options INTERFACE
    $<${is_guarded}:-fstack-protector-strong> $<${is_guarded}:-fstack-clash-protection>
    $<$<STREQUAL:${CMAKE_SYSTEM_PROCESSOR},x86_64>:-fcf-protection>)
  target_link_options(limn_options INTERFACE -Wl,-z,relro -Wl,-z,now)
endif()

if(LIMN_SANITIZER)
  target_compile_options(limn_options INTERFACE
    -fsanitize=${LIMN_SANITIZER} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  if(LIMN_SANITIZER MATCHES "undefined")
    # The address sanitizer sees these too, and each of them is code at every access.
    target_compile_options(limn_options INTERFACE
      -fno-sanitize=null,object-size,vptr
      $<$<BOOL:$<TARGET_PROPERTY:LIMN_IS_NOT_WATCHED>>:-fno-sanitize=undefined>)
  endif()
  target_link_options(limn_options INTERFACE -fsanitize=${LIMN_SANITIZER})
endif()

if(CMAKE_UNITY_BUILD)
  # Files are compiled several at a time (the presets that are built from nothing do so: it takes a
  # third of the time). GCC then thinks that a .cpp file's own types were a header's.
  target_compile_options(limn_options INTERFACE
    $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
endif()

# limn_compile_quickly(TARGET): for what runs once or waits for a person. Optimising it takes longer
# than it ever runs for under a sanitizer. With property LIMN_IS_NOT_WATCHED it is also spared the
# checks for undefined behaviour: tests, where what they call is to be watched.
function(limn_compile_quickly target)
  if(LIMN_SANITIZER)
    target_compile_options(${target} PRIVATE -O0)
  endif()
endfunction()
