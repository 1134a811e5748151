function(step expected)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${ROOT}
    OUTPUT_VARIABLE output ERROR_VARIABLE output RESULT_VARIABLE code)
  if(NOT code EQUAL 0 OR NOT output MATCHES "${expected}")
    message(FATAL_ERROR "${ARGN}\n${code}\n${output}")
  endif()
endfunction()

file(REMOVE_RECURSE ${ROOT})
file(MAKE_DIRECTORY ${ROOT})
step("" ${CMAKE_COMMAND} --install ${BUILD_DIR} --component program --prefix ${ROOT}/usr)
foreach(file
    bin/limn share/applications/org.limn.Limn.desktop share/metainfo/org.limn.Limn.metainfo.xml
    share/mime/packages/limn.xml share/man/man1/limn.1.gz share/doc/limn/copyright
    share/icons/hicolor/scalable/apps/limn.svg share/icons/hicolor/256x256/apps/limn.png)
  if(NOT EXISTS ${ROOT}/usr/${file})
    message(FATAL_ERROR "${file} is not installed")
  endif()
endforeach()

# No variable of this environment, the home folder least of all, and no file beside the program.
set(run /usr/bin/env -i PATH=/usr/bin:/bin HOME=${ROOT} LSAN_OPTIONS=$ENV{LSAN_OPTIONS}
  ${ROOT}/usr/bin/limn)
step("limn [0-9]" ${run} --version)
step("faces" ${run} info creature)
step("" ${run} refine cube --paint faces=0:=2 -o refined.obj)
step("" ${run} render cube --paint faces=0:=2 --size 64x64 -o picture.png)
foreach(file refined.obj picture.png)
  file(SIZE ${ROOT}/${file} size)
  if(size EQUAL 0)
    message(FATAL_ERROR "${file} is empty")
  endif()
endforeach()
file(REMOVE_RECURSE ${ROOT})
