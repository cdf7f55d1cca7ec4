//! Large memory in large pages: so a build takes a five-hundredth of the page faults, and rays that go everywhere find
//! where memory is.

/// Asks the system to hold memory in large pages, before it is used. Where it cannot, nothing changes.
pub(crate) fn prefer_huge_pages<T>(memory: &[T]) {
    #[cfg(target_os = "linux")]
    {
        /// Less is not worth the call.
        const LEAST: usize = 4 << 20;
        const PAGE: usize = 4096;
        let range = memory.as_ptr_range();
        let (start, end) = ((range.start as usize).next_multiple_of(PAGE), range.end as usize & !(PAGE - 1));
        if size_of_val(memory) >= LEAST && start < end {
            // SAFETY: the pages from `start` to `end` lie within `memory`, which is borrowed; the advice changes what
            // kind of pages they are, never what they hold
            #[allow(unsafe_code, reason = "the system's call")]
            unsafe {
                libc::madvise(start as *mut libc::c_void, end - start, libc::MADV_HUGEPAGE);
            }
        }
    }
    #[cfg(not(target_os = "linux"))]
    let _ = memory;
}
