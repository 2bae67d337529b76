# Sourced by checks that try something in a clean root of Debian: a folder of its own (debootstrap, some 500 MB, below
# TMPDIR), deleted at the end; this system is not touched. The caller has set `name`, how its messages begin.
[ "$(id -u)" -eq 0 ] || { echo "$name: debootstrap and chroot need root (you are not root) call it with sudo" >&2; exit 2; }
command -v debootstrap > /dev/null ||
  { echo "$name: there is no debootstrap (it makes the clean root) call apt-get install debootstrap" >&2; exit 2; }

work=$(mktemp -d)
root=$work/root # a caller that makes several gives each another folder of $work

clean() {
  for mounted in "$work"/*/dev/shm "$work"/*/dev/pts "$work"/*/proc; do
    if mountpoint -q "$mounted"; then umount "$mounted" || umount -l "$mounted"; fi
  done
  rm -rf --one-file-system "$work"
}
trap clean EXIT

say() { echo "== $*"; }

# inside COMMAND ...: in the clean root, with a plain environment.
inside() {
  chroot "$root" env -i PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C \
    DEBIAN_FRONTEND=noninteractive OMP_NUM_THREADS=1 "$@"
}

# make_clean_root RELEASE MIRROR: bookworm is Debian 12, trixie Debian 13.
make_clean_root() {
  debootstrap --variant=minbase "$1" "$root" "$2" > "$work/log" 2>&1 || { tail -n 20 "$work/log"; exit 1; }
  echo force-unsafe-io > "$root/etc/dpkg/dpkg.cfg.d/unsafe-io" # the root is thrown away: dpkg need not wait for the disk
  mount -t proc proc "$root/proc"
  mkdir -p "$root/dev/shm" "$root/dev/pts"
  mount -t tmpfs tmpfs "$root/dev/shm" # OpenMPI and browsers share memory there
  mount -t devpts devpts "$root/dev/pts" -o newinstance,ptmxmode=0666 2> /dev/null || true
  for settings in /etc/apt/apt.conf.d/*; do # certificates and proxies of this machine, if there are any
    if grep -qi 'proxy\|Check-' "$settings"; then cp "$settings" "$root/etc/apt/apt.conf.d/"; fi
  done
  inside apt-get update -qq > "$work/log" 2>&1 || { tail -n 20 "$work/log"; exit 1; }
}
