//! Sessions as programs embed them: positions of many forms, changes between steps, what searches
//! may ask for, what there is as data, and what may go to other threads.

mod any_order;
mod changes;
mod data;
mod ends_early;
mod forms;
mod leaving;
mod limits;
mod send_sync;
