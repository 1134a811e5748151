# limn_embed(TARGET NAMESPACE FILE...)
#
# Compiles files into TARGET, so that the program finds its shaders and meshes wherever it is
# started from. Generates a header "embedded/<last part of NAMESPACE>.h" with
#   namespace NAMESPACE { std::span<const EmbeddedFile> files(); }
# listing the files by name, in the order given.
# Everything generated, without compiling it: what tools that read the sources need.
add_custom_target(limn_generated)

set(LIMN_EMBED_SCRIPT ${CMAKE_CURRENT_LIST_DIR}/embed_files.cmake)

function(limn_embed target namespace)
  string(REGEX REPLACE ".*::" "" room ${namespace})
  set(out ${CMAKE_CURRENT_BINARY_DIR}/embedded)
  set(inputs)
  foreach(file IN LISTS ARGN)
    cmake_path(ABSOLUTE_PATH file BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} NORMALIZE)
    list(APPEND inputs ${file})
  endforeach()
  string(REPLACE ";" "|" joined "${inputs}")
  add_custom_command(
    OUTPUT ${out}/${room}.cpp ${out}/${room}.h
    COMMAND ${CMAKE_COMMAND} -DINPUTS=${joined} -DNAMESPACE=${namespace} -DROOM=${room}
      -DOUT=${out} -P ${LIMN_EMBED_SCRIPT}
    DEPENDS ${inputs} ${LIMN_EMBED_SCRIPT}
    COMMENT "Embedding ${room}"
    VERBATIM)
  add_custom_target(${target}_generated_${room} DEPENDS ${out}/${room}.cpp ${out}/${room}.h)
  add_dependencies(limn_generated ${target}_generated_${room})
  # An object library of this folder, since the rule above is known to targets of this folder alone
  # and TARGET may belong to another one.
  add_library(${target}_embedded_${room} OBJECT ${out}/${room}.cpp ${out}/${room}.h)
  set_target_properties(${target}_embedded_${room} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  target_link_libraries(${target}_embedded_${room} PRIVATE limn_options)
  target_include_directories(${target}_embedded_${room} PRIVATE ${CMAKE_CURRENT_BINARY_DIR})
  target_sources(${target} PRIVATE $<TARGET_OBJECTS:${target}_embedded_${room}>)
  target_include_directories(${target} PRIVATE ${CMAKE_CURRENT_BINARY_DIR})
endfunction()
