# What keeps the sources in order: `cmake --build --preset <any> --target format` and so on. The
# scripts can be run by themselves, too.
add_custom_target(format COMMAND ${PROJECT_SOURCE_DIR}/cmake/format.sh USES_TERMINAL VERBATIM)
add_custom_target(format_check COMMAND ${PROJECT_SOURCE_DIR}/cmake/format.sh --check
                  USES_TERMINAL VERBATIM)
add_custom_target(tidy COMMAND ${PROJECT_SOURCE_DIR}/cmake/tidy.sh USES_TERMINAL VERBATIM)
add_custom_target(cppcheck COMMAND ${PROJECT_SOURCE_DIR}/cmake/cppcheck.sh USES_TERMINAL VERBATIM)
