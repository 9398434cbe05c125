#!/usr/bin/env bash
# Compile the proofs and the program extracted from them; leave it as proved-checker in _build.
set -euo pipefail
cd "$(dirname "$0")"

packages=()
command -v coqc >/dev/null 2>&1 || packages+=(coq)
command -v ocamlfind >/dev/null 2>&1 || packages+=(ocaml-findlib)
ocamlfind query zarith >/dev/null 2>&1 || packages+=(libzarith-ocaml-dev)

if [ "${#packages[@]}" -gt 0 ]; then
  if [ "$(id -u)" -ne 0 ] || ! command -v apt-get >/dev/null 2>&1; then
    echo "error: these system packages are missing: ${packages[*]} (Debian's names); install them" >&2
    exit 1
  fi
  echo "installing ${packages[*]}"
  export DEBIAN_FRONTEND=noninteractive
  apt-get update -qq </dev/null
  apt-get install -y -qq --no-install-recommends "${packages[@]}" </dev/null
fi

rm -rf _build
mkdir _build
cp ./*.v */*.v program/*.ml _build/
cd _build

# Two at a time, each after those that it builds on; Extract.v prints what the theorems rest on.
coqdep ./*.v > dependencies 2>/dev/null
printf '%%.vo: %%.v\n\t@echo "coqc $<"; coqc $<\n' > rules
mapfile -t compiled < <(ls ./*.v | grep -v Extract.v | sed 's/$/o/; s/^\.\///')
MAKEFLAGS="" make --silent --jobs=2 --file=rules --file=dependencies "${compiled[@]}"
coqc Extract.v | tee assumptions.txt

# The axioms of Coq's real numbers, and nothing else.
known='ClassicalDedekindReals.sig_forall_dec
ClassicalDedekindReals.sig_not_dec
FunctionalExtensionality.functional_extensionality_dep'
theorems=$(grep -c '^Axioms:$' assumptions.txt)
others=$(sed -e '/^ /d' -e '/^Axioms:$/d' -e 's/ :.*//' assumptions.txt | grep -vxF "$known" || true)
if [ "$theorems" -ne "$(grep -c '^Print Assumptions' Extract.v)" ] || [ -n "$others" ]; then
  echo "error: the theorems rest on more than Coq's real numbers: $others" >&2
  exit 1
fi

ocamlfind ocamlopt -package zarith -linkpkg \
  checker.mli checker.ml json.ml reader.ml tree_reader.ml grasp_reader.ml assembly_reader.ml planes_reader.ml signs_reader.ml weights_reader.ml main.ml -o proved-checker
echo "proofs_check/formal/_build/proved-checker"
