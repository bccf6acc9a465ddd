mod periodic;
