#!/usr/bin/env bash
# package.sh
# Builds the program and a Debian package of it in build/release, and has lintian look at it.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
scripts/install-packages.sh program packaging
scripts/build.sh release limn limn_packaging
(cd build/release && cpack -G DEB)
package=$(ls -t build/release/limn_*.deb | head -n 1)
lintian --fail-on error --suppress-tags bad-distribution-in-changes-file "$package"
desktop-file-validate packaging/org.limn.Limn.desktop
appstreamcli validate --no-net packaging/org.limn.Limn.metainfo.xml
echo "$package"
