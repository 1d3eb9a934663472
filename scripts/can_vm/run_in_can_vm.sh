#!/usr/bin/env bash
# Runs a command where Linux has CAN, with two fresh virtual interfaces, vcan0 and vcan1, that are up.
#   run_in_can_vm.sh COMMAND [ARGUMENT]...
#   run_in_can_vm.sh --which              only says where
# Where: "native", a network namespace of its own, when this kernel has CAN; otherwise "uml", User Mode Linux: a second
# kernel as a process (Debian's user-mode-linux; neither root nor KVM). CAN_VM_BACKEND=native|uml asks for one of them.
# The command sees this file system, this environment and folder, and a loopback network of its own; its output and exit
# status come through. No standard input. Exit status 125: CAN untested, there is nowhere to run.
# CAN_VM_MODULES names further kernel modules ("slcan sch_tbf"), CAN_VM_MEMORY (512M) is the second kernel's memory,
# CAN_VM_TIMEOUT (600) how many seconds it may take.
set -uo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
backend=${CAN_VM_BACKEND:-}
memory=${CAN_VM_MEMORY:-512M}
limit=${CAN_VM_TIMEOUT:-600}
export CAN_VM_MODULES=${CAN_VM_MODULES:-}
export PATH=$PATH:/usr/sbin:/sbin

has_native()
{
  $namespace sh -c 'modprobe -q vcan echo=1; modprobe -q can_raw; ip link add vcan0 type vcan && ip link set vcan0 up' \
    2>/dev/null
}

# User Mode Linux 6.1 keeps a process's registers in a buffer that is too small for processors with AMX: its first process dies.
has_uml()
{
  ! grep -qsw amx_tile /proc/cpuinfo && command -v linux.uml modprobe ip >/dev/null &&
    compgen -G '/usr/lib/uml/modules/*/kernel/drivers/net/can/vcan.ko' >/dev/null
}

# As root a namespace is enough; others need to be root of one of users as well, and the modules loaded.
namespace="unshare --net"
[[ $EUID -eq 0 ]] || namespace="unshare --map-root-user --net"
for candidate in ${backend:-native uml} none; do
  [[ $candidate == none ]] || ! "has_$candidate" || break
done
if [[ $candidate == none ]]; then
  echo "CAN untested: this kernel has no CAN; and user-mode-linux, kmod and iproute2 are not all installed, or the processor has AMX" >&2
  exit 125
fi
echo "SocketCAN: $candidate" >&2
[[ $# -gt 0 && $1 != --which ]] || exit $(($# == 0 ? 2 : 0))

# --- What the other side needs to know, in a folder both see -----------------------------------------------------
control=$(mktemp -d /tmp/can_vm.XXXXXX) || exit 125
machine=
stop()
{
  [[ -z $machine ]] || { kill -TERM "$machine" 2>/dev/null; wait "$machine" 2>/dev/null; }
  rm -rf "$control"
}
trap stop EXIT
trap 'exit 130' INT
trap 'exit 143' TERM

cp "$here/guest.sh" "$control/guest"
export -p >"$control/environment"
printf '%q ' "$@" >"$control/command"
pwd >"$control/folder"
touch "$control/stdout" "$control/stderr"

# The second kernel's memory is a file without a name that must be executable: in /dev/shm, unless that is mounted
# noexec or small, as in containers.
memory_folder()
{
  local needed
  needed=$(($(numfmt --from=iec "$memory") / 1024))
  if findmnt --noheadings --output OPTIONS /dev/shm 2>/dev/null | grep -qv noexec &&
    [[ $(df --output=avail -k /dev/shm | tail -n 1) -ge $needed ]]; then
    echo /dev/shm
  else
    echo /tmp
  fi
}

start_native()
{
  CAN_VM_CONTROL=$control CAN_VM_BACKEND=native \
    timeout "$limit" $namespace "$control/guest" </dev/null >"$control/console" 2>&1 &
}

# The kernel hands what it does not know, CAN_VM_..., to its first process as environment.
start_uml()
{
  env -u TMP -u TEMP TMPDIR="$(memory_folder)" HOME="$control" \
    timeout "$limit" linux.uml "mem=$memory" umid=can_vm "uml_dir=$control/uml/" \
    root=/dev/root rootfstype=hostfs rootflags=/ rw "init=$control/guest" \
    "CAN_VM_CONTROL=$control" CAN_VM_BACKEND=uml "CAN_VM_MODULES=${CAN_VM_MODULES// /,}" \
    con=null con0=null,fd:1 panic=1 quiet </dev/null >"$control/console" 2>&1 &
}

"start_$candidate"
machine=$!
tail --quiet --lines=+1 --sleep-interval=0.1 --follow --pid="$machine" "$control/stdout" 2>/dev/null &
out=$!
tail --quiet --lines=+1 --sleep-interval=0.1 --follow --pid="$machine" "$control/stderr" >&2 2>/dev/null &
err=$!
wait "$machine"
machine=
wait "$out" "$err"
[[ -s $control/status ]] && exit "$(<"$control/status")"
echo "CAN untested: $candidate did not run the command to its end:" >&2
tail -n 40 "$control/console" >&2
exit 125
