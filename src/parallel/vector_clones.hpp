#pragma once

/// Marks a function whose loops the compiler vectorises: it is built for the plain machine and for wider
/// vectors, and the loader picks what the processor has. Sums are not contracted or reordered
/// (-ffp-contract=off), so every version gives the same bits.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) &&     \
    !defined(__SANITIZE_THREAD__)
#define TOWFORM_VECTOR_CLONES __attribute__((target_clones("default", "avx2", "arch=x86-64-v4")))
#else
#define TOWFORM_VECTOR_CLONES
#endif

/// Before a loop whose turns do not depend on each other, where the compiler cannot see it.
#if defined(__GNUC__) && !defined(__clang__)
#define TOWFORM_INDEPENDENT _Pragma("GCC ivdep")
#else
#define TOWFORM_INDEPENDENT
#endif

/// Before a loop of few turns that takes its time in counting them.
#if defined(__GNUC__) && !defined(__clang__)
#define TOWFORM_UNROLLED _Pragma("GCC unroll 4")
#else
#define TOWFORM_UNROLLED
#endif

/// Before a loop as long as a vector, which the compiler would take apart before it vectorises.
#if defined(__GNUC__) && !defined(__clang__)
#define TOWFORM_WHOLE _Pragma("GCC ivdep") _Pragma("GCC unroll 1")
#else
#define TOWFORM_WHOLE
#endif
