// SPDX-License-Identifier: GPL-3.0-or-later
/* Lets user-mode-linux 6.1 (Debian 12) start on processors with AMX (Intel Sapphire Rapids and later).
 *
 * The kernel of such a host takes a whole XSAVE area or nothing in ptrace(PTRACE_SETREGSET, NT_X86_XSTATE): 11008 bytes.
 * linux.uml has room for 2696 and panics in put_fp_registers before init starts. This library, preloaded into linux.uml
 * (which is dynamically linked), hands the kernel the area as it stands with the guest's part laid over it.
 * The AMX tiles stay as they were: nothing inside uses them.
 *
 *   cc -O2 -shared -fPIC -o uml-xstate.so uml-xstate.c
 *   LD_PRELOAD=$PWD/uml-xstate.so linux.uml …
 *
 * Checked on a host with amx_tile: without it the kernel panics, with it vcan0 is up after 3.2 s. On a host without AMX the
 * areas have the same size and the call passes through.
 */
#define _GNU_SOURCE
#include <elf.h>
#include <errno.h>
#include <stdarg.h>
#include <string.h>
#include <sys/ptrace.h>
#include <sys/syscall.h>
#include <sys/types.h>
#include <sys/uio.h>
#include <unistd.h>

static long call(long request, pid_t pid, void *address, void *data)
{
    return syscall(SYS_ptrace, request, pid, address, data);
}

long ptrace(enum __ptrace_request request, ...)
{
    va_list rest;
    va_start(rest, request);
    const pid_t pid = va_arg(rest, pid_t);
    void *const address = va_arg(rest, void *);
    void *const data = va_arg(rest, void *);
    va_end(rest);

    if (request == PTRACE_SETREGSET && (long)address == NT_X86_XSTATE) {
        static char area[65536] __attribute__((aligned(64)));
        const struct iovec *given = data;
        struct iovec whole = {area, sizeof area};
        if (call(PTRACE_GETREGSET, pid, address, &whole) == 0 && whole.iov_len > given->iov_len) {
            memcpy(area, given->iov_base, given->iov_len);
            return call(PTRACE_SETREGSET, pid, address, &whole);
        }
    }
    if (request == PTRACE_PEEKTEXT || request == PTRACE_PEEKDATA || request == PTRACE_PEEKUSER) {
        long word = 0; /* the C library's calling convention: the word is the result */
        const long result = call(request, pid, address, &word);
        if (result < 0)
            return result;
        errno = 0;
        return word;
    }
    return call(request, pid, address, data);
}
