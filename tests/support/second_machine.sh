#!/bin/bash
# Two network namespaces with a cable between them, for tests: `bash second_machine.sh SITE FOLDER
# SERVER... -- CLIENT...`. SERVER runs here, at 10.77.0.1, until CLIENT ends, which runs on the
# other side, at 10.77.0.2, once SERVER has printed an address for phones. Its browser trusts
# FOLDER/authority.pem and what else the system does. Start it with `unshare -n -m`.
set -u
folder=$1
shift
server=()
while [ "$1" != -- ]; do
  server+=("$1")
  shift
done
shift
ip link set lo up
ip link add cable type veth peer name plug
unshare -n sleep 600 &
far=$!
here=$(readlink /proc/self/ns/net)
until [ "$(readlink /proc/$far/ns/net)" != "$here" ]; do sleep 0.1; done
ip link set plug netns $far
ip addr add 10.77.0.1/24 dev cable
ip link set cable up
nsenter -t $far -n ip link set lo up
nsenter -t $far -n ip addr add 10.77.0.2/24 dev plug
nsenter -t $far -n ip link set plug up
"${server[@]}" >"$folder/said" 2>&1 &
served=$!
until grep -q 'phone: ' "$folder/said"; do
  kill -0 $served 2>/dev/null || break
  sleep 0.2
done
# What the system's administrator lets Chromium trust, in this mount namespace alone.
mkdir -p "$folder/chromium/policies/managed"
printf '{"CACertificates": ["%s"]}' "$(grep -v -- ---- "$folder/authority.pem" | tr -d '\n')" \
  >"$folder/chromium/policies/managed/trust.json"
mount --bind "$folder/chromium" /etc/chromium
nsenter -t $far -n "$@"
status=$?
kill -INT $served
wait $served
echo "server: $?" >>"$folder/said"
kill $far
exit $status
