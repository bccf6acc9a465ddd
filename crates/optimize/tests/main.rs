mod closed_forms;
mod periodic;
