mod closed_forms;
mod periodic;
mod regions;
