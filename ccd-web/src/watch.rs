//! Exceptions inside the module with the kernels, told to `js/gpu.js`: a call that one of them ends
//! never settles its promise.

use std::cell::RefCell;
use std::pin::pin;
use std::sync::atomic::{AtomicBool, Ordering};
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
extern "C" {
    /// A function of JavaScript.
    #[wasm_bindgen(js_name = Function)]
    pub type Function;

    /// Calls it with the text of a panic.
    #[wasm_bindgen(method)]
    fn call(this: &Function, receiver: &JsValue, text: &str);
}

thread_local! {
    /// What takes the texts of panics.
    static TOLD: RefCell<Option<Function>> = const { RefCell::new(None) };
}

/// Whether a call is polled: between polls, whether an exception ended one.
static POLLED: AtomicBool = AtomicBool::new(false);

/// From now on the text of a panic goes to this function first.
#[wasm_bindgen]
pub fn on_panic(told: Function) {
    TOLD.set(Some(told));
}

/// Whether an exception ended a call: a panic, a trap, or what an import threw.
#[wasm_bindgen]
pub fn is_cut_off() -> bool {
    POLLED.load(Ordering::Relaxed)
}

/// Gives the text of a panic to the function that takes it.
pub fn tell(text: &str) {
    TOLD.with_borrow(|told| {
        if let Some(told) = told {
            told.call(&JsValue::NULL, text);
        }
    });
}

/// A call whose polls are watched for [`is_cut_off`].
pub async fn watched<T>(call: impl Future<Output = T>) -> T {
    let mut call = pin!(call);
    std::future::poll_fn(|task| {
        POLLED.store(true, Ordering::Relaxed);
        let state = call.as_mut().poll(task);
        POLLED.store(false, Ordering::Relaxed);
        state
    })
    .await
}
