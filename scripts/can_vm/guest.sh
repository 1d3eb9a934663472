#!/bin/bash
# What run_in_can_vm.sh runs on the other side: loads the modules, brings the interfaces up, runs the command. In the
# second kernel this is the first process, and switches it off. Builtins where possible: a fork takes 20 ms there.
export PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin
control=$CAN_VM_CONTROL
backend=$CAN_VM_BACKEND
modules=${CAN_VM_MODULES//,/ }
unset CAN_VM_CONTROL CAN_VM_BACKEND CAN_VM_MODULES

mount_system()
{
  mount -t proc proc /proc
  mount -t sysfs sysfs /sys
  [[ $(</proc/mounts) == *' /dev devtmpfs'* ]] || mount -t devtmpfs devtmpfs /dev
  mkdir -p /dev/pts /dev/shm
  mount -t devpts -o ptmxmode=666 devpts /dev/pts
  mount -t tmpfs -o mode=1777 shm /dev/shm
  mount -t tmpfs -o mode=755 run /run
  echo localhost >/proc/sys/kernel/hostname
  # Where modprobe looks below its root for those of this kernel.
  mkdir -p /run/lock /run/uml/lib
  ln -s /usr/lib/uml/modules /run/uml/lib/modules
  modules_root=/run/uml
}

# With echo=1 vcan itself returns what was sent, as real controllers do. Only so do queueing disciplines act on local
# receivers.
load_modules()
{
  modprobe --dirname="${modules_root:-/}" vcan echo=1
  modprobe --dirname="${modules_root:-/}" -a can_raw can_dev $modules
}

make_interfaces()
{
  ip -batch - <<'END'
link set lo up
link add vcan0 type vcan
link set vcan0 up
link add vcan1 type vcan
link set vcan1 up
END
}

run_command()
{
  (
    source "$control/environment"
    cd "$(<"$control/folder")" && source "$control/command" </dev/null >>"$control/stdout" 2>>"$control/stderr"
  )
  echo $? >"$control/status.new"
  mv "$control/status.new" "$control/status"
}

[[ $backend == native ]] || mount_system
load_modules
make_interfaces && run_command
[[ $backend == native ]] && exit
sync
echo o >/proc/sysrq-trigger
sleep 20
