//! Sessions as programs embed them: every method and pipeline, positions of many forms, changes
//! between steps, what searches may ask for, what there is as data, and what may go to other
//! threads.

mod candidate_sets;
mod data;
mod ends_early;
mod exact_mode;
mod few_move;
mod first_contacts;
mod forms;
mod found;
mod fronts;
mod groups;
mod leaving;
mod limits;
mod moving_bodies;
mod oriented_triangles;
mod rigid_bodies;
mod rules;
mod send_sync;
mod triangles;
mod units;
