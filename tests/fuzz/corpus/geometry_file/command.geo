Point(1) = {0, 0, 0}; SystemCall "touch x";
