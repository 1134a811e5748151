# limn_embed(TARGET NAMESPACE FILE...)
#
# Compiles files into TARGET, so that the program finds its shaders and meshes wherever it is
# started from. Generates a header "embedded/<last part of NAMESPACE>.h" with
#   namespace NAMESPACE { std::span<const EmbeddedFile> files(); }
# listing the files by name, in the order given.
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
  target_sources(${target} PRIVATE ${out}/${room}.cpp ${out}/${room}.h)
  target_include_directories(${target} PRIVATE ${CMAKE_CURRENT_BINARY_DIR})
endfunction()
