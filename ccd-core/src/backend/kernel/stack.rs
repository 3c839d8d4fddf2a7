//! A stack in a thread's own memory, in which nothing is written before it is pushed: to write
//! zeros into 31 words first took a GPU a fifth of a traversal's time (benches/NOTES.md).

use core::mem::MaybeUninit;

/// At most `N` words: a push of one more, and a pop of none, fails a check.
#[derive(Clone, Copy, Debug)]
pub struct Stack<const N: usize> {
    /// Those below `height` are written.
    words: [MaybeUninit<u32>; N],
    height: u32,
}

impl<const N: usize> Stack<N> {
    /// Without a word.
    #[inline(always)]
    pub fn new() -> Self {
        Self { words: [MaybeUninit::uninit(); N], height: 0 }
    }

    /// Number of words.
    #[inline(always)]
    pub fn height(&self) -> u32 {
        self.height
    }

    /// Puts a word on top.
    #[inline(always)]
    pub fn push(&mut self, word: u32) {
        self.words[self.height as usize] = MaybeUninit::new(word);
        self.height += 1;
    }

    /// Takes the word on top.
    #[inline(always)]
    pub fn pop(&mut self) -> u32 {
        self.height -= 1;
        let top = self.words[self.height as usize];
        // SAFETY: all words below a height have been pushed.
        #[allow(unsafe_code, reason = "words above the height are not written")]
        return unsafe { top.assume_init() };
    }
}

impl<const N: usize> Default for Stack<N> {
    fn default() -> Self {
        Self::new()
    }
}
