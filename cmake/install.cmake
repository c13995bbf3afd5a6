# What `cmake --install` puts where, under any prefix:
#   bin/sidestep                      the program
#   share/sidestep/{models,scenarios} what it finds relative to itself
#   include/sidestep/...              the headers, by their paths from the root of the sources
#   lib/sidestep/*.a, lib/cmake/sidestep/   the rooms' libraries; find_package(sidestep)
# Component `sidestep` is the first two, `sidestep-dev` the others.
include(CMakePackageConfigHelpers)

# sidestep_libraries(<variable> <folder>): every library of the folder and those below it.
function(sidestep_libraries variable folder)
  get_property(targets DIRECTORY ${folder} PROPERTY BUILDSYSTEM_TARGETS)
  get_property(folders DIRECTORY ${folder} PROPERTY SUBDIRECTORIES)
  set(libraries)
  foreach(target ${targets})
    get_target_property(type ${target} TYPE)
    if(type MATCHES "STATIC_LIBRARY|INTERFACE_LIBRARY")
      list(APPEND libraries ${target})
    endif()
  endforeach()
  foreach(below ${folders})
    sidestep_libraries(more ${below})
    list(APPEND libraries ${more})
  endforeach()
  set(${variable} ${libraries} PARENT_SCOPE)
endfunction()

set(rooms)
foreach(floor models controller sim)
  sidestep_libraries(libraries ${PROJECT_SOURCE_DIR}/${floor})
  list(APPEND rooms ${libraries})
endforeach()

list(REMOVE_ITEM rooms sidestep_console)  # the program's own words on the screen

# One name for all of them; the linker takes only what a program calls.
add_library(sidestep_everything INTERFACE)
target_link_libraries(sidestep_everything INTERFACE ${rooms})
set_target_properties(sidestep_everything PROPERTIES EXPORT_NAME sidestep)
add_library(sidestep::sidestep ALIAS sidestep_everything)

set(config_folder ${CMAKE_INSTALL_LIBDIR}/cmake/sidestep)
install(TARGETS sidestep RUNTIME COMPONENT sidestep)
install(TARGETS sidestep_options sidestep_everything ${rooms} EXPORT sidestepTargets
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}/sidestep COMPONENT sidestep-dev)
install(EXPORT sidestepTargets NAMESPACE sidestep:: DESTINATION ${config_folder}
        COMPONENT sidestep-dev)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/sidestepConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_SOURCE_DIR}/cmake/sidestepConfig.cmake
              ${PROJECT_SOURCE_DIR}/cmake/dependencies.cmake
              ${PROJECT_BINARY_DIR}/sidestepConfigVersion.cmake
        DESTINATION ${config_folder} COMPONENT sidestep-dev)

# A room's headers lie beside its sources.
foreach(room ${rooms})
  get_target_property(folder ${room} SOURCE_DIR)
  list(APPEND folders ${folder})
endforeach()
list(REMOVE_DUPLICATES folders)
foreach(folder ${folders})
  cmake_path(RELATIVE_PATH folder BASE_DIRECTORY ${PROJECT_SOURCE_DIR} OUTPUT_VARIABLE relative)
  install(DIRECTORY ${folder}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/sidestep/${relative}
          COMPONENT sidestep-dev FILES_MATCHING PATTERN "*.h" PATTERN "example" EXCLUDE)
endforeach()

install(DIRECTORY scenarios DESTINATION ${CMAKE_INSTALL_DATADIR}/sidestep COMPONENT sidestep)
file(GLOB robots ${PROJECT_SOURCE_DIR}/models/*/robot.yaml)
foreach(robot ${robots})
  cmake_path(GET robot PARENT_PATH folder)
  install(DIRECTORY ${folder} DESTINATION ${CMAKE_INSTALL_DATADIR}/sidestep/models
          COMPONENT sidestep)
endforeach()
install(FILES README.md LICENSE CHANGELOG.md CITATION.cff TYPE DOC COMPONENT sidestep)
