#!/usr/bin/env bash
# cppcheck.sh: cppcheck over every source of ours. Prints its findings and nothing else; exits with
# 1 if there are any. Exceptions stand in the sources (`cppcheck-suppress`) or here, with a reason:
#   missingIncludeSystem, unknownMacro   it reads no system headers: what they bring is no finding
#   internalAstError                     it doesn't follow all of C++20
#   passedByValue                        it takes two numbers for too many; clang-tidy measures them
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
cppcheck --enable=warning,performance,portability --library=googletest --std=c++20 --inline-suppr \
  --suppress=missingIncludeSystem --suppress=unknownMacro --suppress=internalAstError \
  --suppress=passedByValue --error-exitcode=1 --quiet -j "$(nproc)" -I . models controller sim tests
