#!/bin/sh
# Calls the webhook "parcel" of the room on this machine: what its rules then do is printed.
set -eu
key=$(cat "${XDG_STATE_HOME:-$HOME/.local/state}/housefly/${1:-bsen}/tasks/webhook-key")
curl --fail-with-body --silent --show-error --request POST \
  --header "Authorization: Bearer $key" "${2:-http://127.0.0.1:8080}/api/v1/webhook/parcel"
