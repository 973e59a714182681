// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/mechanics/library_names.hpp"

#include <array>
#include <string_view>

namespace torsor {
namespace {

/// Functions of <math.h>, each of which is there for other types too: sin, sinf, sinl, sinf64x.
constexpr std::string_view mathematical_functions =
    " acos acosh asin asinh atan atan2 atanh canonicalize cbrt ceil copysign cos cosh drem erf erfc exp exp10 exp2 "
    "expm1 fabs fdim finite floor fma fmax fmaximum fmaximum_mag fmaximum_mag_num fmaximum_num fmaxmag fmin fminimum "
    "fminimum_mag fminimum_mag_num fminimum_num fminmag fmod frexp fromfp fromfpx gamma getpayload hypot ilogb j0 j1 "
    "jn ldexp lgamma llogb llrint llround log log10 log1p log2 logb lrint lround modf nan nearbyint nextafter "
    "nextdown nexttoward nextup pow remainder remquo rint round roundeven scalb scalbln scalbn setpayload "
    "setpayloadsig significand sin sincos sinh sqrt tan tanh tgamma totalorder totalordermag trunc ufromfp ufromfpx "
    "y0 y1 yn ";

/// Functions, types and variables of the C library and of POSIX, and functions that g++ knows without any header.
constexpr std::string_view global_names =
    " FILE F_OWNER_GID F_OWNER_PGRP F_OWNER_PID F_OWNER_TID PTHREAD_MUTEX_ADAPTIVE_NP PTHREAD_MUTEX_DEFAULT "
    "PTHREAD_MUTEX_ERRORCHECK PTHREAD_MUTEX_ERRORCHECK_NP PTHREAD_MUTEX_FAST_NP PTHREAD_MUTEX_NORMAL "
    "PTHREAD_MUTEX_RECURSIVE PTHREAD_MUTEX_RECURSIVE_NP PTHREAD_MUTEX_ROBUST PTHREAD_MUTEX_ROBUST_NP "
    "PTHREAD_MUTEX_STALLED PTHREAD_MUTEX_STALLED_NP PTHREAD_MUTEX_TIMED_NP PTHREAD_PRIO_INHERIT PTHREAD_PRIO_NONE "
    "PTHREAD_PRIO_PROTECT PTHREAD_RWLOCK_DEFAULT_NP PTHREAD_RWLOCK_PREFER_READER_NP "
    "PTHREAD_RWLOCK_PREFER_WRITER_NONRECURSIVE_NP PTHREAD_RWLOCK_PREFER_WRITER_NP P_ALL P_PGID P_PID P_PIDFD a64l "
    "abort abs access acct adjtime alarm aligned_alloc arc4random arc4random_buf arc4random_uniform asctime "
    "asctime_r asprintf at_quick_exit atexit atof atoi atol atoll basename bcmp bcopy bind_textdomain_codeset "
    "bindtextdomain blkcnt64_t blkcnt_t blksize_t brk bsearch btowc bzero cabs cabsf cabsl cacos cacosf cacosh "
    "cacoshf cacoshl cacosl caddr_t calloc canonicalize_file_name carg cargf cargl casin casinf casinh casinhf "
    "casinhl casinl catan catanf catanh catanhf catanhl catanl ccos ccosf ccosh ccoshf ccoshl ccosl cexp cexpf cexpl "
    "chdir chown chroot cimag cimagf cimagl clearenv clearerr clearerr_unlocked clock clock_adjtime "
    "clock_getcpuclockid clock_getres clock_gettime clock_nanosleep clock_settime clock_t clockid_t clog clog10 "
    "clog10f clog10l clogf clogl clone close close_range closefrom comparison_fn_t confstr conj conjf conjl "
    "cookie_close_function_t cookie_io_functions_t cookie_read_function_t cookie_seek_function_t "
    "cookie_write_function_t copy_file_range coro_destroy coro_done coro_promise coro_resume cpow cpowf cpowl cproj "
    "cprojf cprojl cpu_set_t creal crealf creall creat creat64 crypt csin csinf csinh csinhf csinhl csinl csqrt "
    "csqrtf csqrtl ctan ctanf ctanh ctanhf ctanhl ctanl ctermid ctime ctime_r cuserid daddl daddr_t daemon daylight "
    "dcgettext dcngettext ddivl dev_t dfmal dgettext difftime div div_t dmull dngettext double_t dprintf drand48 "
    "drand48_data drand48_r dsqrtl dsubl dup dup2 dup3 duplocale dysize eaccess ecvt ecvt_r endusershell environ "
    "erand48 erand48_r error_t euidaccess execl execle execlp execv execve execveat execvp execvpe exit "
    "explicit_bzero f_owner_ex fabsd128 fabsd32 fabsd64 faccessat fadd faddl fallocate fallocate64 fchdir fchown "
    "fchownat fclose fcloseall fcntl fcntl64 fcvt fcvt_r fd_mask fd_set fdatasync fdiv fdivl fdopen feclearexcept "
    "fegetenv fegetexceptflag fegetround feholdexcept feof feof_unlocked feraiseexcept ferror ferror_unlocked "
    "fesetenv fesetexceptflag fesetround fetestexcept feupdateenv fexecve fflush fflush_unlocked ffma ffmal ffs "
    "ffsimax ffsl ffsll fgetc fgetc_unlocked fgetpos fgetpos64 fgets fgets_unlocked fgetwc fgetwc_unlocked fgetws "
    "fgetws_unlocked file_handle fileno fileno_unlocked finited128 finited32 finited64 float_t flock flock64 "
    "flockfile fmemopen fmul fmull fopen fopen64 fopencookie fork fpathconf fpos64_t fpos_t fpregset_t fprintf "
    "fprintf_unlocked fputc fputc_unlocked fputs fputs_unlocked fputwc fputwc_unlocked fputws fputws_unlocked fread "
    "fread_unlocked free freelocale freopen freopen64 fsblkcnt64_t fsblkcnt_t fscanf fseek fseeko fseeko64 fsetpos "
    "fsetpos64 fsfilcnt64_t fsfilcnt_t fsid_t fsqrt fsqrtl fsub fsubl fsync ftell ftello ftello64 ftruncate "
    "ftruncate64 ftrylockfile funlockfile futimes futimesat fwide fwprintf fwrite fwrite_unlocked fwscanf gamma_r "
    "gammaf_r gammal_r gcvt get_current_dir_name getc getc_unlocked getchar getchar_unlocked getcpu getcwd getdate "
    "getdate_err getdate_r getdelim getdomainname getdtablesize getegid getentropy getenv geteuid getgid getgroups "
    "gethostid gethostname getitimer getline getloadavg getlogin getlogin_r getopt getpagesize getpass getpgid "
    "getpgrp getpid getppid getpt getresgid getresuid getsid getsubopt gettext gettid gettimeofday getuid "
    "getusershell getw getwc getwc_unlocked getwchar getwchar_unlocked getwd gid_t gmtime gmtime_r grantpt greg_t "
    "gregset_t group_member gsignal id_t idtype_t imaxabs index initstate initstate_r ino64_t ino_t int16_t int32_t "
    "int64_t int8_t int_fast16_t int_fast32_t int_fast64_t int_fast8_t int_least16_t int_least32_t int_least64_t "
    "int_least8_t intmax_t intptr_t iovec isalnum isalnum_l isalpha isalpha_l isascii isatty isblank isblank_l "
    "iscntrl iscntrl_l isctype isdigit isdigit_l isgraph isgraph_l isinfd128 isinfd32 isinfd64 isinff isinfl islower "
    "islower_l isnand128 isnand32 isnand64 isnanf isnanl isprint isprint_l ispunct ispunct_l isspace isspace_l "
    "isupper isupper_l iswalnum iswalnum_l iswalpha iswalpha_l iswblank iswblank_l iswcntrl iswcntrl_l iswctype "
    "iswctype_l iswdigit iswdigit_l iswgraph iswgraph_l iswlower iswlower_l iswprint iswprint_l iswpunct iswpunct_l "
    "iswspace iswspace_l iswupper iswupper_l iswxdigit iswxdigit_l isxdigit isxdigit_l itimerspec itimerval jrand48 "
    "jrand48_r key_t kill killpg l64a labs lchown lcong48 lcong48_r lconv ldiv ldiv_t lgamma_r lgammaf128_r "
    "lgammaf32_r lgammaf32x_r lgammaf64_r lgammaf64x_r lgammaf_r lgammal_r link linkat llabs lldiv lldiv_t locale_t "
    "localeconv localtime localtime_r lockf lockf64 loff_t lrand48 lrand48_r lseek lseek64 lutimes malloc "
    "max_align_t mblen mbrlen mbrtowc mbsinit mbsnrtowcs mbsrtowcs mbstate_t mbstowcs mbtowc mcontext_t memccpy "
    "memchr memcmp memcpy memfrob memmem memmove mempcpy memrchr memset mkdtemp mkostemp mkostemp64 mkostemps "
    "mkostemps64 mkstemp mkstemp64 mkstemps mkstemps64 mktemp mktime mode_t mrand48 mrand48_r name_to_handle_at "
    "nand128 nand32 nand64 nanosleep newlocale ngettext nice nlink_t nrand48 nrand48_r nullptr_t obstack "
    "obstack_printf obstack_vprintf off64_t off_t on_exit open open64 open_by_handle_at open_memstream "
    "open_wmemstream openat openat64 optarg opterr optind optopt pathconf pause pclose perror pid_t pipe pipe2 popen "
    "posix_fadvise posix_fadvise64 posix_fallocate posix_fallocate64 posix_memalign posix_openpt pow10 pow10f pow10l "
    "pread pread64 printf printf_unlocked profil program_invocation_name program_invocation_short_name pselect "
    "psiginfo psignal pthread_atfork pthread_attr_destroy pthread_attr_getaffinity_np pthread_attr_getdetachstate "
    "pthread_attr_getguardsize pthread_attr_getinheritsched pthread_attr_getschedparam pthread_attr_getschedpolicy "
    "pthread_attr_getscope pthread_attr_getsigmask_np pthread_attr_getstack pthread_attr_getstackaddr "
    "pthread_attr_getstacksize pthread_attr_init pthread_attr_setaffinity_np pthread_attr_setdetachstate "
    "pthread_attr_setguardsize pthread_attr_setinheritsched pthread_attr_setschedparam pthread_attr_setschedpolicy "
    "pthread_attr_setscope pthread_attr_setsigmask_np pthread_attr_setstack pthread_attr_setstackaddr "
    "pthread_attr_setstacksize pthread_attr_t pthread_barrier_destroy pthread_barrier_init pthread_barrier_t "
    "pthread_barrier_wait pthread_barrierattr_destroy pthread_barrierattr_getpshared pthread_barrierattr_init "
    "pthread_barrierattr_setpshared pthread_barrierattr_t pthread_cancel pthread_clockjoin_np pthread_cond_broadcast "
    "pthread_cond_clockwait pthread_cond_destroy pthread_cond_init pthread_cond_signal pthread_cond_t "
    "pthread_cond_timedwait pthread_cond_wait pthread_condattr_destroy pthread_condattr_getclock "
    "pthread_condattr_getpshared pthread_condattr_init pthread_condattr_setclock pthread_condattr_setpshared "
    "pthread_condattr_t pthread_create pthread_detach pthread_equal pthread_exit pthread_getaffinity_np "
    "pthread_getattr_default_np pthread_getattr_np pthread_getconcurrency pthread_getcpuclockid pthread_getname_np "
    "pthread_getschedparam pthread_getspecific pthread_join pthread_key_create pthread_key_delete pthread_key_t "
    "pthread_kill pthread_mutex_clocklock pthread_mutex_consistent pthread_mutex_consistent_np pthread_mutex_destroy "
    "pthread_mutex_getprioceiling pthread_mutex_init pthread_mutex_lock pthread_mutex_setprioceiling pthread_mutex_t "
    "pthread_mutex_timedlock pthread_mutex_trylock pthread_mutex_unlock pthread_mutexattr_destroy "
    "pthread_mutexattr_getprioceiling pthread_mutexattr_getprotocol pthread_mutexattr_getpshared "
    "pthread_mutexattr_getrobust pthread_mutexattr_getrobust_np pthread_mutexattr_gettype pthread_mutexattr_init "
    "pthread_mutexattr_setprioceiling pthread_mutexattr_setprotocol pthread_mutexattr_setpshared "
    "pthread_mutexattr_setrobust pthread_mutexattr_setrobust_np pthread_mutexattr_settype pthread_mutexattr_t "
    "pthread_once pthread_once_t pthread_rwlock_clockrdlock pthread_rwlock_clockwrlock pthread_rwlock_destroy "
    "pthread_rwlock_init pthread_rwlock_rdlock pthread_rwlock_t pthread_rwlock_timedrdlock "
    "pthread_rwlock_timedwrlock pthread_rwlock_tryrdlock pthread_rwlock_trywrlock pthread_rwlock_unlock "
    "pthread_rwlock_wrlock pthread_rwlockattr_destroy pthread_rwlockattr_getkind_np pthread_rwlockattr_getpshared "
    "pthread_rwlockattr_init pthread_rwlockattr_setkind_np pthread_rwlockattr_setpshared pthread_rwlockattr_t "
    "pthread_self pthread_setaffinity_np pthread_setattr_default_np pthread_setcancelstate pthread_setcanceltype "
    "pthread_setconcurrency pthread_setname_np pthread_setschedparam pthread_setschedprio pthread_setspecific "
    "pthread_sigmask pthread_sigqueue pthread_spin_destroy pthread_spin_init pthread_spin_lock pthread_spin_trylock "
    "pthread_spin_unlock pthread_spinlock_t pthread_t pthread_testcancel pthread_timedjoin_np pthread_tryjoin_np "
    "pthread_yield ptrdiff_t ptsname ptsname_r putc putc_unlocked putchar putchar_unlocked putenv puts puts_unlocked "
    "putw putwc putwc_unlocked putwchar putwchar_unlocked pwrite pwrite64 qecvt qecvt_r qfcvt qfcvt_r qgcvt qsort "
    "qsort_r quad_t quick_exit raise rand rand_r random random_data random_r rawmemchr read readahead readlink "
    "readlinkat realloc reallocarray realpath register_t remove rename renameat renameat2 revoke rewind rindex rmdir "
    "rpmatch rsize_t rusage sbrk scanf sched_get_priority_max sched_get_priority_min sched_getaffinity sched_getcpu "
    "sched_getparam sched_getscheduler sched_param sched_rr_get_interval sched_setaffinity sched_setparam "
    "sched_setscheduler sched_yield secure_getenv seed48 seed48_r select sem_clockwait sem_close sem_destroy "
    "sem_getvalue sem_init sem_open sem_post sem_t sem_timedwait sem_trywait sem_unlink sem_wait setbuf setbuffer "
    "setdomainname setegid setenv seteuid setgid sethostid sethostname setitimer setlinebuf setlocale setlogin setns "
    "setpgid setpgrp setregid setresgid setresuid setreuid setsid setstate setstate_r settimeofday setuid "
    "setusershell setvbuf sig_atomic_t sig_t sigabbrev_np sigaction sigaddset sigaltstack sigandset sigblock "
    "sigcontext sigdelset sigdescr_np sigemptyset sigevent sigevent_t sigfillset siggetmask sighandler_t sighold "
    "sigignore siginfo_t siginterrupt sigisemptyset sigismember signal signbitd128 signbitd32 signbitd64 signbitf "
    "signbitl signgam sigorset sigpause sigpending sigprocmask sigqueue sigrelse sigreturn sigset sigset_t "
    "sigsetmask sigstack sigsuspend sigtimedwait sigval sigval_t sigwait sigwaitinfo size_t sleep snprintf socklen_t "
    "splice sprintf srand srand48 srand48_r srandom srandom_r sscanf ssignal ssize_t stack_t stat stat64 stpcpy "
    "stpncpy strcasecmp strcasecmp_l strcasestr strcat strchr strchrnul strcmp strcoll strcoll_l strcpy strcspn "
    "strdup strerror strerror_l strerror_r strerrordesc_np strerrorname_np strfmon strfromd strfromf strfromf128 "
    "strfromf32 strfromf32x strfromf64 strfromf64x strfroml strfry strftime strftime_l strlen strncasecmp "
    "strncasecmp_l strncat strncmp strncpy strndup strnlen strpbrk strptime strptime_l strrchr strsep strsignal "
    "strspn strstr strtod strtod_l strtof strtof128 strtof128_l strtof32 strtof32_l strtof32x strtof32x_l strtof64 "
    "strtof64_l strtof64x strtof64x_l strtof_l strtok strtok_r strtol strtol_l strtold strtold_l strtoll strtoll_l "
    "strtoq strtoul strtoul_l strtoull strtoull_l strtouq strverscmp strxfrm strxfrm_l suseconds_t swab swprintf "
    "swscanf symlink symlinkat sync sync_file_range syncfs syscall sysconf system sysv_signal tcgetpgrp tcsetpgrp "
    "tee tempnam textdomain tgkill time time_t timegm timelocal timer_create timer_delete timer_getoverrun "
    "timer_gettime timer_settime timer_t timespec timespec_get timespec_getres timeval timex timezone tm tmpfile "
    "tmpfile64 tmpnam tmpnam_r toascii tolower tolower_l toupper toupper_l towctrans towctrans_l towlower towlower_l "
    "towupper towupper_l truncate truncate64 ttyname ttyname_r ttyslot tzname tzset u_char u_int u_int16_t u_int32_t "
    "u_int64_t u_int8_t u_long u_quad_t u_short ualarm ucontext_t uid_t uint uint16_t uint32_t uint64_t uint8_t "
    "uint_fast16_t uint_fast32_t uint_fast64_t uint_fast8_t uint_least16_t uint_least32_t uint_least64_t "
    "uint_least8_t uintmax_t uintptr_t ulong ungetc ungetwc unlink unlinkat unlockpt unsetenv unshare useconds_t "
    "uselocale ushort usleep utimes va_list valloc vasprintf vdprintf vfork vfprintf vfscanf vfwprintf vfwscanf "
    "vhangup vmsplice vprintf vscanf vsnprintf vsprintf vsscanf vswprintf vswscanf vwprintf vwscanf wait wait3 wait4 "
    "waitid waitpid wcpcpy wcpncpy wcrtomb wcscasecmp wcscasecmp_l wcscat wcschr wcschrnul wcscmp wcscoll wcscoll_l "
    "wcscpy wcscspn wcsdup wcsftime wcsftime_l wcslen wcsncasecmp wcsncasecmp_l wcsncat wcsncmp wcsncpy wcsnlen "
    "wcsnrtombs wcspbrk wcsrchr wcsrtombs wcsspn wcsstr wcstod wcstod_l wcstof wcstof128 wcstof128_l wcstof32 "
    "wcstof32_l wcstof32x wcstof32x_l wcstof64 wcstof64_l wcstof64x wcstof64x_l wcstof_l wcstok wcstol wcstol_l "
    "wcstold wcstold_l wcstoll wcstoll_l wcstombs wcstoq wcstoul wcstoul_l wcstoull wcstoull_l wcstouq wcswcs "
    "wcswidth wcsxfrm wcsxfrm_l wctob wctomb wctrans wctrans_l wctrans_t wctype wctype_l wctype_t wcwidth wint_t "
    "wmemchr wmemcmp wmemcpy wmemmove wmempcpy wmemset wprintf write wscanf ";

/// Those that identifier.cpp does not know by a family. SYS_... are the numbers of calls of the system.
constexpr std::string_view library_macros =
    " ADJ_ESTERROR ADJ_FREQUENCY ADJ_MAXERROR ADJ_MICRO ADJ_NANO ADJ_OFFSET ADJ_OFFSET_SINGLESHOT ADJ_OFFSET_SS_READ "
    "ADJ_SETOFFSET ADJ_STATUS ADJ_TAI ADJ_TICK ADJ_TIMECONST AIO_PRIO_DELTA_MAX ATOMIC_BOOL_LOCK_FREE "
    "ATOMIC_CHAR16_T_LOCK_FREE ATOMIC_CHAR32_T_LOCK_FREE ATOMIC_CHAR8_T_LOCK_FREE ATOMIC_CHAR_LOCK_FREE "
    "ATOMIC_FLAG_INIT ATOMIC_INT_LOCK_FREE ATOMIC_LLONG_LOCK_FREE ATOMIC_LONG_LOCK_FREE ATOMIC_POINTER_LOCK_FREE "
    "ATOMIC_SHORT_LOCK_FREE ATOMIC_VAR_INIT ATOMIC_WCHAR_T_LOCK_FREE AT_EACCESS AT_EMPTY_PATH AT_FDCWD "
    "AT_NO_AUTOMOUNT AT_RECURSIVE AT_REMOVEDIR AT_STATX_DONT_SYNC AT_STATX_FORCE_SYNC AT_STATX_SYNC_AS_STAT "
    "AT_STATX_SYNC_TYPE AT_SYMLINK_FOLLOW AT_SYMLINK_NOFOLLOW BC_BASE_MAX BC_DIM_MAX BC_SCALE_MAX BC_STRING_MAX "
    "BOOL_MAX BOOL_WIDTH BUFSIZ BUS_ADRALN BUS_ADRERR BUS_MCEERR_AO BUS_MCEERR_AR BUS_OBJERR CLD_CONTINUED "
    "CLD_DUMPED CLD_EXITED CLD_KILLED CLD_STOPPED CLD_TRAPPED CLOCKS_PER_SEC CLOCK_BOOTTIME CLOCK_BOOTTIME_ALARM "
    "CLOCK_MONOTONIC CLOCK_MONOTONIC_COARSE CLOCK_MONOTONIC_RAW CLOCK_PROCESS_CPUTIME_ID CLOCK_REALTIME "
    "CLOCK_REALTIME_ALARM CLOCK_REALTIME_COARSE CLOCK_TAI CLOCK_THREAD_CPUTIME_ID CLONE_CHILD_CLEARTID "
    "CLONE_CHILD_SETTID CLONE_DETACHED CLONE_FILES CLONE_FS CLONE_IO CLONE_NEWCGROUP CLONE_NEWIPC CLONE_NEWNET "
    "CLONE_NEWNS CLONE_NEWPID CLONE_NEWTIME CLONE_NEWUSER CLONE_NEWUTS CLONE_PARENT CLONE_PARENT_SETTID CLONE_PIDFD "
    "CLONE_PTRACE CLONE_SETTLS CLONE_SIGHAND CLONE_SYSVSEM CLONE_THREAD CLONE_UNTRACED CLONE_VFORK CLONE_VM "
    "CLOSE_RANGE_CLOEXEC CLOSE_RANGE_UNSHARE COLL_WEIGHTS_MAX CPU_ALLOC CPU_ALLOC_SIZE CPU_AND CPU_AND_S CPU_CLR "
    "CPU_CLR_S CPU_COUNT CPU_COUNT_S CPU_EQUAL CPU_EQUAL_S CPU_FREE CPU_ISSET CPU_ISSET_S CPU_OR CPU_OR_S CPU_SET "
    "CPU_SETSIZE CPU_SET_S CPU_XOR CPU_XOR_S CPU_ZERO CPU_ZERO_S CSIGNAL DELAYTIMER_MAX DN_ACCESS DN_ATTRIB "
    "DN_CREATE DN_DELETE DN_MODIFY DN_MULTISHOT DN_RENAME E2BIG EACCES EADDRINUSE EADDRNOTAVAIL EADV EAFNOSUPPORT "
    "EAGAIN EALREADY EBADE EBADF EBADFD EBADMSG EBADR EBADRQC EBADSLT EBFONT EBUSY ECANCELED ECHILD ECHRNG ECOMM "
    "ECONNABORTED ECONNREFUSED ECONNRESET EDEADLK EDEADLOCK EDESTADDRREQ EDOM EDOTDOT EDQUOT EEXIST EFAULT EFBIG "
    "EHOSTDOWN EHOSTUNREACH EHWPOISON EIDRM EILSEQ EINPROGRESS EINTR EINVAL EIO EISCONN EISDIR EISNAM EKEYEXPIRED "
    "EKEYREJECTED EKEYREVOKED EL2HLT EL2NSYNC EL3HLT EL3RST ELIBACC ELIBBAD ELIBEXEC ELIBMAX ELIBSCN ELNRNG ELOOP "
    "EMEDIUMTYPE EMFILE EMLINK EMSGSIZE EMULTIHOP ENAMETOOLONG ENAVAIL ENETDOWN ENETRESET ENETUNREACH ENFILE ENOANO "
    "ENOBUFS ENOCSI ENODATA ENODEV ENOENT ENOEXEC ENOKEY ENOLCK ENOLINK ENOMEDIUM ENOMEM ENOMSG ENONET ENOPKG "
    "ENOPROTOOPT ENOSPC ENOSR ENOSTR ENOSYS ENOTBLK ENOTCONN ENOTDIR ENOTEMPTY ENOTNAM ENOTRECOVERABLE ENOTSOCK "
    "ENOTSUP ENOTTY ENOTUNIQ ENXIO EOPNOTSUPP EOVERFLOW EOWNERDEAD EPERM EPFNOSUPPORT EPIPE EPROTO EPROTONOSUPPORT "
    "EPROTOTYPE ERANGE EREMCHG EREMOTE EREMOTEIO ERESTART ERFKILL EROFS ESHUTDOWN ESOCKTNOSUPPORT ESPIPE ESRCH "
    "ESRMNT ESTALE ESTRPIPE ETIME ETIMEDOUT ETOOMANYREFS ETXTBSY EUCLEAN EUNATCH EUSERS EWOULDBLOCK EXDEV EXFULL "
    "EXPR_NEST_MAX FALLOC_FL_COLLAPSE_RANGE FALLOC_FL_INSERT_RANGE FALLOC_FL_KEEP_SIZE FALLOC_FL_NO_HIDE_STALE "
    "FALLOC_FL_PUNCH_HOLE FALLOC_FL_UNSHARE_RANGE FALLOC_FL_ZERO_RANGE FAPPEND FASYNC FFSYNC FILENAME_MAX FNDELAY "
    "FNONBLOCK FOPEN_MAX FPE_CONDTRAP FPE_FLTDIV FPE_FLTINV FPE_FLTOVF FPE_FLTRES FPE_FLTSUB FPE_FLTUND FPE_FLTUNK "
    "FPE_INTDIV FPE_INTOVF F_ADD_SEALS F_DUPFD F_DUPFD_CLOEXEC F_EXLCK F_GETFD F_GETFL F_GETLEASE F_GETLK F_GETLK64 "
    "F_GETOWN F_GETOWN_EX F_GETPIPE_SZ F_GETSIG F_GET_FILE_RW_HINT F_GET_RW_HINT F_GET_SEALS F_LOCK F_NOTIFY "
    "F_OFD_GETLK F_OFD_SETLK F_OFD_SETLKW F_OK F_RDLCK F_SEAL_FUTURE_WRITE F_SEAL_GROW F_SEAL_SEAL F_SEAL_SHRINK "
    "F_SEAL_WRITE F_SETFD F_SETFL F_SETLEASE F_SETLK F_SETLK64 F_SETLKW F_SETLKW64 F_SETOWN F_SETOWN_EX F_SETPIPE_SZ "
    "F_SETSIG F_SET_FILE_RW_HINT F_SET_RW_HINT F_SHLCK F_TEST F_TLOCK F_ULOCK F_UNLCK F_WRLCK HOST_NAME_MAX "
    "ILL_BADIADDR ILL_BADSTK ILL_COPROC ILL_ILLADR ILL_ILLOPC ILL_ILLOPN ILL_ILLTRP ILL_PRVOPC ILL_PRVREG IOV_MAX "
    "ITIMER_PROF ITIMER_REAL ITIMER_VIRTUAL LC_ADDRESS LC_ADDRESS_MASK LC_ALL LC_ALL_MASK LC_COLLATE LC_COLLATE_MASK "
    "LC_CTYPE LC_CTYPE_MASK LC_GLOBAL_LOCALE LC_IDENTIFICATION LC_IDENTIFICATION_MASK LC_MEASUREMENT "
    "LC_MEASUREMENT_MASK LC_MESSAGES LC_MESSAGES_MASK LC_MONETARY LC_MONETARY_MASK LC_NAME LC_NAME_MASK LC_NUMERIC "
    "LC_NUMERIC_MASK LC_PAPER LC_PAPER_MASK LC_TELEPHONE LC_TELEPHONE_MASK LC_TIME LC_TIME_MASK LINE_MAX LOCK_EX "
    "LOCK_MAND LOCK_NB LOCK_READ LOCK_RW LOCK_SH LOCK_UN LOCK_WRITE LOGIN_NAME_MAX L_INCR L_SET L_XTND L_ctermid "
    "L_cuserid L_tmpnam MAX_CANON MAX_HANDLE_SZ MAX_INPUT MINSIGSTKSZ MOD_CLKA MOD_CLKB MOD_ESTERROR MOD_FREQUENCY "
    "MOD_MAXERROR MOD_MICRO MOD_NANO MOD_OFFSET MOD_STATUS MOD_TAI MOD_TIMECONST MQ_PRIO_MAX NAME_MAX NGREG "
    "NGROUPS_MAX NL_ARGMAX NL_LANGMAX NL_MSGMAX NL_NMAX NL_SETMAX NL_TEXTMAX NSIG NZERO O_ACCMODE O_APPEND O_ASYNC "
    "O_CLOEXEC O_CREAT O_DIRECT O_DIRECTORY O_DSYNC O_EXCL O_FSYNC O_LARGEFILE O_NDELAY O_NOATIME O_NOCTTY "
    "O_NOFOLLOW O_NONBLOCK O_PATH O_RDONLY O_RDWR O_RSYNC O_SYNC O_TMPFILE O_TRUNC O_WRONLY PATH_MAX PIPE_BUF "
    "POLL_ERR POLL_HUP POLL_IN POLL_MSG POLL_OUT POLL_PRI POSIX_FADV_DONTNEED POSIX_FADV_NOREUSE POSIX_FADV_NORMAL "
    "POSIX_FADV_RANDOM POSIX_FADV_SEQUENTIAL POSIX_FADV_WILLNEED PTHREAD_ADAPTIVE_MUTEX_INITIALIZER_NP "
    "PTHREAD_ATTR_NO_SIGMASK_NP PTHREAD_BARRIER_SERIAL_THREAD PTHREAD_CANCELED PTHREAD_CANCEL_ASYNCHRONOUS "
    "PTHREAD_CANCEL_DEFERRED PTHREAD_CANCEL_DISABLE PTHREAD_CANCEL_ENABLE PTHREAD_COND_INITIALIZER "
    "PTHREAD_CREATE_DETACHED PTHREAD_CREATE_JOINABLE PTHREAD_DESTRUCTOR_ITERATIONS "
    "PTHREAD_ERRORCHECK_MUTEX_INITIALIZER_NP PTHREAD_EXPLICIT_SCHED PTHREAD_INHERIT_SCHED PTHREAD_KEYS_MAX "
    "PTHREAD_MUTEX_INITIALIZER PTHREAD_ONCE_INIT PTHREAD_PROCESS_PRIVATE PTHREAD_PROCESS_SHARED "
    "PTHREAD_RECURSIVE_MUTEX_INITIALIZER_NP PTHREAD_RWLOCK_INITIALIZER "
    "PTHREAD_RWLOCK_WRITER_NONRECURSIVE_INITIALIZER_NP PTHREAD_SCOPE_PROCESS PTHREAD_SCOPE_SYSTEM PTHREAD_STACK_MIN "
    "P_tmpdir REG_CR2 REG_CSGSFS REG_EFL REG_ERR REG_OLDMASK REG_R10 REG_R11 REG_R12 REG_R13 REG_R14 REG_R15 REG_R8 "
    "REG_R9 REG_RAX REG_RBP REG_RBX REG_RCX REG_RDI REG_RDX REG_RIP REG_RSI REG_RSP REG_TRAPNO RENAME_EXCHANGE "
    "RENAME_NOREPLACE RENAME_WHITEOUT RE_DUP_MAX RTSIG_MAX RWF_WRITE_LIFE_NOT_SET RWH_WRITE_LIFE_EXTREME "
    "RWH_WRITE_LIFE_LONG RWH_WRITE_LIFE_MEDIUM RWH_WRITE_LIFE_NONE RWH_WRITE_LIFE_NOT_SET RWH_WRITE_LIFE_SHORT R_OK "
    "SA_INTERRUPT SA_NOCLDSTOP SA_NOCLDWAIT SA_NODEFER SA_NOMASK SA_ONESHOT SA_ONSTACK SA_RESETHAND SA_RESTART "
    "SA_SIGINFO SA_STACK SCHED_BATCH SCHED_DEADLINE SCHED_FIFO SCHED_IDLE SCHED_ISO SCHED_OTHER SCHED_RESET_ON_FORK "
    "SCHED_RR SEEK_CUR SEEK_DATA SEEK_END SEEK_HOLE SEEK_SET SEGV_ACCADI SEGV_ACCERR SEGV_ADIDERR SEGV_ADIPERR "
    "SEGV_BNDERR SEGV_MAPERR SEGV_MTEAERR SEGV_MTESERR SEGV_PKUERR SEM_FAILED SEM_VALUE_MAX SIGABRT SIGALRM SIGBUS "
    "SIGCHLD SIGCLD SIGCONT SIGEV_NONE SIGEV_SIGNAL SIGEV_THREAD SIGEV_THREAD_ID SIGFPE SIGHUP SIGILL SIGINT SIGIO "
    "SIGIOT SIGKILL SIGPIPE SIGPOLL SIGPROF SIGPWR SIGQUIT SIGRTMAX SIGRTMIN SIGSEGV SIGSTKFLT SIGSTKSZ SIGSTOP "
    "SIGSYS SIGTERM SIGTRAP SIGTSTP SIGTTIN SIGTTOU SIGURG SIGUSR1 SIGUSR2 SIGVTALRM SIGWINCH SIGXCPU SIGXFSZ "
    "SIG_BLOCK SIG_DFL SIG_ERR SIG_HOLD SIG_IGN SIG_SETMASK SIG_UNBLOCK SI_ASYNCIO SI_ASYNCNL SI_DETHREAD SI_KERNEL "
    "SI_MESGQ SI_QUEUE SI_SIGIO SI_TIMER SI_TKILL SI_USER SPLICE_F_GIFT SPLICE_F_MORE SPLICE_F_MOVE "
    "SPLICE_F_NONBLOCK SS_DISABLE SS_ONSTACK STA_CLK STA_CLOCKERR STA_DEL STA_FLL STA_FREQHOLD STA_INS STA_MODE "
    "STA_NANO STA_PLL STA_PPSERROR STA_PPSFREQ STA_PPSJITTER STA_PPSSIGNAL STA_PPSTIME STA_PPSWANDER STA_RONLY "
    "STA_UNSYNC STDERR_FILENO STDIN_FILENO STDOUT_FILENO SYNC_FILE_RANGE_WAIT_AFTER SYNC_FILE_RANGE_WAIT_BEFORE "
    "SYNC_FILE_RANGE_WRITE SYNC_FILE_RANGE_WRITE_AND_WAIT S_IFBLK S_IFCHR S_IFDIR S_IFIFO S_IFLNK S_IFMT S_IFREG "
    "S_IFSOCK S_IRGRP S_IROTH S_IRUSR S_IRWXG S_IRWXO S_IRWXU S_ISGID S_ISUID S_ISVTX S_IWGRP S_IWOTH S_IWUSR "
    "S_IXGRP S_IXOTH S_IXUSR TEMP_FAILURE_RETRY TIMER_ABSTIME TIMESPEC_TO_TIMEVAL TIMEVAL_TO_TIMESPEC TIME_UTC "
    "TMP_MAX TRAP_BRANCH TRAP_BRKPT TRAP_HWBKPT TRAP_TRACE TRAP_UNK TTY_NAME_MAX UTIME_NOW UTIME_OMIT WAIT_ANY "
    "WAIT_MYPGRP WCOREFLAG WEOF WORD_BIT W_EXITCODE W_OK W_STOPCODE XATTR_LIST_MAX XATTR_NAME_MAX XATTR_SIZE_MAX "
    "X_OK pthread_cleanup_pop pthread_cleanup_pop_restore_np pthread_cleanup_push pthread_cleanup_push_defer_np "
    "sa_handler sa_sigaction sched_priority si_addr si_addr_lsb si_arch si_band si_call_addr si_fd si_int si_lower "
    "si_overrun si_pid si_pkey si_ptr si_status si_stime si_syscall si_timerid si_uid si_upper si_utime si_value "
    "sigev_notify_attributes sigev_notify_function sigmask st_atime st_ctime st_mtime timeradd timerclear timercmp "
    "timerisset timersub va_arg va_copy va_end va_start ";

bool lists(std::string_view list, std::string_view name) {
  const std::size_t at = list.find(" " + std::string(name) + " ");
  return at != std::string_view::npos;
}

bool is_mathematical_function(std::string_view name) {
  static constexpr std::array<std::string_view, 9> types{"f128x", "f64x", "f32x", "f128", "f64", "f32", "f16", "f", "l"};
  if (lists(mathematical_functions, name)) return true;
  for (const std::string_view type : types) {
    if (name.ends_with(type) && lists(mathematical_functions, name.substr(0, name.size() - type.size()))) return true;
  }
  return false;
}

/// f32addf64: a sum, product, ... rounded to another type.
bool is_narrowing_function(std::string_view name) {
  static constexpr std::array<std::string_view, 6> operations{"add", "sub", "mul", "div", "fma", "sqrt"};
  static constexpr std::array<std::string_view, 4> results{"f32x", "f64x", "f32", "f64"};
  static constexpr std::array<std::string_view, 5> types{"f64x", "f32x", "f128", "f64", "f32"};
  for (const std::string_view result : results) {
    for (const std::string_view operation : operations) {
      for (const std::string_view type : types) {
        if (name == std::string(result) + std::string(operation) + std::string(type)) return true;
      }
    }
  }
  return false;
}

}  // namespace

bool is_library_macro(const std::string& name) { return name.rfind("SYS_", 0) == 0 || lists(library_macros, name); }

bool is_global_library_name(const std::string& name) {
  return lists(global_names, name) || is_mathematical_function(name) || is_narrowing_function(name);
}

}  // namespace torsor
