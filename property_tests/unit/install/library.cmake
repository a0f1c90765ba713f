# cmake -D SOURCE=… -D WORK=… -D COMPILER=… -D LAUNCHER=… -P library.cmake: builds the library without the laboratory, installs it into
# a folder of its own, and builds and runs a program that finds it there with find_package(rayproof).
file(REMOVE_RECURSE ${WORK})
set(run COMMAND_ERROR_IS_FATAL ANY)
set(options -G Ninja -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER} -D CMAKE_BUILD_TYPE=Release)
execute_process(COMMAND ${CMAKE_COMMAND} -S ${SOURCE} -B ${WORK}/library ${options} -D RAYPROOF_LAB=OFF ${run})
execute_process(COMMAND ${CMAKE_COMMAND} --build ${WORK}/library ${run})
execute_process(COMMAND ${CMAKE_COMMAND} --install ${WORK}/library --prefix ${WORK}/prefix OUTPUT_QUIET ${run})
execute_process(COMMAND ${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/consumer -B ${WORK}/consumer ${options}
                        -D CMAKE_PREFIX_PATH=${WORK}/prefix ${run})
execute_process(COMMAND ${CMAKE_COMMAND} --build ${WORK}/consumer ${run})
execute_process(COMMAND ${WORK}/consumer/consumer ${run})
