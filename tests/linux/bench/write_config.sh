# Functions that write configurations of a bench: no bus, no lines, profiles in place of sensors.
# Sourced by the tests of the program.

# write_config FILE RATE_HZ FOLDER TENDON...     TENDON: `parameter block:profile`
write_config() {
  local file="$1" rate="$2" folder="$3" tendon
  shift 3
  mkdir -p "$folder/store"
  cat > "$file" << EOF
schema = 1
[node]
id = 7
[can]
interface = "none"
log = "$folder/frames.log"
[loop]
rate_Hz = $rate
[store]
folder = "$folder/store"
[sensor]
kind = "profile"
at_end = "stop"
[gpio]
chip = "none"
EOF
  for tendon in "$@"; do
    printf '[[tendon]]\nparameters = "%s"\nprofile = "%s"\n' "${tendon%%:*}" "${tendon#*:}" >> "$file"
  done
}
