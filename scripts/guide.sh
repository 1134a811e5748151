#!/usr/bin/env bash
# guide.sh
# Draws the pictures of docs/guide.md and the README's window with the program as it is, and writes
# the guide's text with the keys that there are. Look at what has changed before you commit it.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
scripts/install-packages.sh program tests
scripts/build.sh release -DLIMN_BUILD_TESTS=ON app_tests
LIMN_UPDATE_GOLDENS=1 build/release/bin/app_tests --gtest_filter='*GuidePicture*:GuideText*:WindowPicture.Dark'
echo "The guide: docs/guide.md"
