#!/usr/bin/env bash
# Runs, from the project's root, every command of README.md's ```sh blocks but `./dev test`, which is what runs this. Each has to succeed, but for
# those that end in `|| true` in the README itself.
set -euo pipefail
cd "$(dirname "$0")/../.."
PATH="$PWD/build/release/bin:$PATH"
count=0
while IFS= read -r line; do
  case "$line" in '' | '#'* | './dev test'*) continue ;; esac
  echo "\$ $line"
  bash -c "$line" </dev/null
  count=$((count + 1))
done < <(sed -n '/^```sh$/,/^```$/p' README.md | grep -v '^```')
echo "$count commands of the README ran"
[ "$count" -ge 4 ]
