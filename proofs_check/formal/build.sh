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
script=$(sha256sum build.sh)
cd _build

# What Coq makes is kept by the hash of all that it depends on, where there is a place for it;
# FORMAL_CACHE= compiles all again.
cache=${FORMAL_CACHE-${XDG_CACHE_HOME:-${HOME:-}/.cache}/slipstates/coq}
key=$({ coqc --version; echo "$script"; sha256sum ./*.v; } | sha256sum | cut -d " " -f 1)

restore() {
  [ -n "$cache" ] && cd "$cache" 2>/dev/null && sha256sum --check --status "$key.sum" 2>/dev/null &&
    tar -xzf "$key.tar.gz" -C "$OLDPWD"
}

keep() {
  [ -n "$cache" ] && mkdir -p "$cache" && tar -czf "$cache/$key.$$" "$@" && cd "$cache" &&
    mv "$key.$$" "$key.tar.gz" && sha256sum "$key.tar.gz" > "$key.sum.$$" && mv "$key.sum.$$" "$key.sum" &&
    find . -type f -mtime +30 -delete
}

if (restore); then
  echo "Coq's results of these sources are in $cache"
else
  # Two at a time, each after those that it builds on; Extract.v prints what the theorems rest on.
  coqdep ./*.v > dependencies 2>/dev/null
  printf '%%.vo: %%.v\n\t@echo "coqc $<"; coqc $<\n' > rules
  mapfile -t compiled < <(ls ./*.v | grep -v Extract.v | sed 's/$/o/; s/^\.\///')
  MAKEFLAGS="" make --silent --jobs=2 --file=rules --file=dependencies "${compiled[@]}"
  coqc Extract.v | tee assumptions.txt
  (keep "${compiled[@]}" assumptions.txt checker.ml checker.mli) 2>/dev/null || true
fi

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
