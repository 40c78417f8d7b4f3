#!/usr/bin/env bash
# The third-party reader of DBC files that the tests compare with.
# Usage: npm_package.sh.
package=candied
version=2.2.0
sha512=r2C6Ekh7nF8TbgLFL94r1SMWijiYKS8MBw6yb99FKVXvpa8OeH15WgRwV6PfPKENVAsMFQP0YU6SqemkUrWmXQ==
files=(dist/index.cjs.js LICENSE)
. "$(dirname "${BASH_SOURCE[0]}")/npm_package.sh"
