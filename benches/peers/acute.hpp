// What all programs here share: the test of a tetrahedron over any ring, reading the files of
// `cargo bench --bench ratios -- --inputs DIRECTORY`, timing, and the line that `run` reads.
#pragma once
#include <algorithm>
#include <array>
#include <ctime>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

// Twelve coordinates of four corners.
template <class T> using Corners = std::array<std::array<T, 3>, 4>;

// Whether the tetrahedron is positively oriented and its six dihedral angles are less than 90 degrees:
// the inner products of the four normals are negative. The operations are those of
// acutile's naive pass.
template <class T> bool is_acute(const Corners<T> &p) {
    std::array<std::array<T, 3>, 3> e;
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++) e[i][k] = p[i + 1][k] - p[0][k];
    auto cross = [](const auto &a, const auto &b) {
        return std::array<T, 3>{T(a[1] * b[2] - a[2] * b[1]), T(a[2] * b[0] - a[0] * b[2]),
                                T(a[0] * b[1] - a[1] * b[0])};
    };
    auto dot = [](const auto &a, const auto &b) { return T(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]); };
    const auto a = cross(e[1], e[2]), b = cross(e[2], e[0]), c = cross(e[0], e[1]);
    const T zero(0);
    if (!(dot(e[0], a) > zero)) return false;
    const T ab = dot(a, b), ac = dot(a, c), bc = dot(b, c);
    if (!(ab < zero && ac < zero && bc < zero)) return false;
    return dot(a, a) + ab + ac > zero && ab + dot(b, b) + bc > zero && ac + bc + dot(c, c) > zero;
}

inline std::vector<double> read_doubles(const std::string &path) {
    std::ifstream file(path, std::ios::binary | std::ios::ate);
    if (!file) { std::fprintf(stderr, "%s: cannot be read\n", path.c_str()); std::exit(2); }
    std::vector<double> list(file.tellg() / sizeof(double));
    file.seekg(0).read(reinterpret_cast<char *>(list.data()), list.size() * sizeof(double));
    return list;
}

inline std::vector<Corners<double>> read_corners(const std::string &path) {
    const auto list = read_doubles(path);
    std::vector<Corners<double>> corners(list.size() / 12);
    for (size_t i = 0; i < list.size(); i++) corners[i / 12][i % 12 / 3][i % 3] = list[i];
    return corners;
}

// A file of exact numbers: the polynomial of the generator and its root, then twelve numbers on each line,
// each with its rational coefficients between commas.
struct Exact {
    std::vector<long> polynomial;
    double root;
    std::vector<std::array<std::vector<std::string>, 12>> rows;
};

inline Exact read_exact(const std::string &path, size_t most) {
    std::ifstream file(path);
    if (!file) { std::fprintf(stderr, "%s: cannot be read\n", path.c_str()); std::exit(2); }
    Exact exact;
    std::string line, word;
    std::getline(file, line);
    std::vector<std::string> words;
    for (std::istringstream head(line); head >> word;) words.push_back(word);
    exact.root = std::stod(words.back());
    words.pop_back();
    for (auto &w : words) exact.polynomial.push_back(std::stol(w));
    while (exact.rows.size() < most && std::getline(file, line)) {
        std::istringstream row(line);
        auto &numbers = exact.rows.emplace_back();
        for (auto &number : numbers) {
            row >> word;
            for (std::istringstream parts(word); std::getline(parts, word, ',');) number.push_back(word);
        }
    }
    return exact;
}

// The seconds that this process has had a processor, as acutile counts its own.
inline double processor_seconds() {
    timespec time;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return time.tv_sec + 1e-9 * time.tv_nsec;
}

// The least seconds of several runs, for about two seconds.
template <class F> double fastest(F work) {
    const double begin = processor_seconds();
    double least = 1e300;
    for (int round = 0; round < 50 && processor_seconds() - begin < 2; round++) {
        const double start = processor_seconds();
        work();
        least = std::min(least, processor_seconds() - start);
    }
    return least;
}

// Counts the acute ones; gives the nanoseconds of one tetrahedron.
template <class T> double count_acute(const std::vector<Corners<T>> &all, size_t &count) {
    return fastest([&] {
        count = 0;
        for (const auto &corners : all) count += is_acute(corners);
    }) * 1e9 / all.size();
}

// One measurement: program, file, tetrahedra looked at, answer, value, its unit.
inline void print(const char *program, const std::string &file, size_t items, size_t answer, double value,
                  const char *unit) {
    std::printf("@peer\t%s\t%s\t%zu\t%zu\t%.6g\t%s\n", program, file.c_str(), items, answer, value, unit);
    std::fflush(stdout);
}

// The doubles nearest to exact numbers, for the naive pass over them.
inline std::vector<Corners<double>> rounded(const Exact &exact) {
    std::vector<Corners<double>> all(exact.rows.size());
    for (size_t i = 0; i < all.size(); i++)
        for (int k = 0; k < 12; k++) {
            double power = 1, value = 0;
            for (const auto &text : exact.rows[i][k]) {
                const auto slash = text.find('/');
                const double q = slash == std::string::npos ? 1 : std::stod(text.substr(slash + 1));
                value += power * std::stod(text.substr(0, slash)) / q;
                power *= exact.root;
            }
            all[i][k / 3][k % 3] = value;
        }
    return all;
}
