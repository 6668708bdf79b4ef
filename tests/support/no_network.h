#pragma once

#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <ucontext.h>

#include <cerrno>
#include <csignal>
#include <cstddef>

namespace furrow::test {

/// How often this process asked for a socket that leads out of the computer since the watch began.
inline volatile std::sig_atomic_t outsideSockets = 0;

inline void refuseSocket(int /*signal*/, siginfo_t* /*what*/, void* context) {
    outsideSockets = outsideSockets + 1;
    // What the call answers.
    auto& machine = static_cast<ucontext_t*>(context)->uc_mcontext;
#if defined(__x86_64__)
    machine.gregs[REG_RAX] = -EACCES;
#elif defined(__aarch64__)
    machine.regs[0] = static_cast<unsigned long long>(-EACCES);
#endif
}

/// From now on this process, and every process that it starts, gets no socket but local ones. In this one
/// each attempt is counted and fails; the others end by SIGSYS. Cannot be taken back. False where the kernel
/// does not allow it.
inline bool watchSockets() {
    struct sigaction action{};
    action.sa_sigaction = refuseSocket;
    action.sa_flags = SA_SIGINFO;
    if (sigaction(SIGSYS, &action, nullptr) != 0) {
        return false;
    }
    sock_filter filter[] = {
        BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_socket, 0, 2),
        BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, args[0])),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, AF_UNIX, 0, 1),
        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_TRAP),
    };
    const sock_fprog program{.len = sizeof(filter) / sizeof(filter[0]), .filter = filter};
    return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
           prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
}

}  // namespace furrow::test
