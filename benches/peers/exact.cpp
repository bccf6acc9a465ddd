// Exact rational and algebraic numbers without filters of the caller: GMP, FLINT and e-antic.
//   exact DIRECTORY
#include "acute.hpp"
#include <gmpxx.h>
#include <e-antic/renfxx.h>
#include <flint/fmpq.h>

// FLINT's rationals with operators.
struct Fmpq {
    fmpq_t x;
    Fmpq(long n = 0) { fmpq_init(x); fmpq_set_si(x, n, 1); }
    Fmpq(const Fmpq &o) { fmpq_init(x); fmpq_set(x, o.x); }
    ~Fmpq() { fmpq_clear(x); }
    Fmpq &operator=(const Fmpq &o) { fmpq_set(x, o.x); return *this; }
    friend Fmpq operator+(const Fmpq &a, const Fmpq &b) { Fmpq r; fmpq_add(r.x, a.x, b.x); return r; }
    friend Fmpq operator-(const Fmpq &a, const Fmpq &b) { Fmpq r; fmpq_sub(r.x, a.x, b.x); return r; }
    friend Fmpq operator*(const Fmpq &a, const Fmpq &b) { Fmpq r; fmpq_mul(r.x, a.x, b.x); return r; }
    friend bool operator<(const Fmpq &a, const Fmpq &b) { return fmpq_cmp(a.x, b.x) < 0; }
    friend bool operator>(const Fmpq &a, const Fmpq &b) { return fmpq_cmp(a.x, b.x) > 0; }
};

template <class T, class F> void measure(const char *program, const std::string &name, const Exact &exact, F number) {
    std::vector<Corners<T>> all(exact.rows.size());
    for (size_t i = 0; i < all.size(); i++)
        for (int k = 0; k < 12; k++) all[i][k / 3][k % 3] = number(exact.rows[i][k]);
    size_t count;
    const double each = count_acute(all, count);
    print(program, name, all.size(), count, each, "ns each");
}

// A polynomial as e-antic reads it.
static std::string written(const std::vector<long> &polynomial) {
    std::string text;
    for (size_t k = polynomial.size(); k-- > 0;) {
        if (polynomial[k] == 0) continue;
        text += polynomial[k] < 0 ? " - " : text.empty() ? "" : " + ";
        text += std::to_string(std::labs(polynomial[k]));
        if (k > 0) text += "*a^" + std::to_string(k);
    }
    return text;
}

int main(int, char **arguments) {
    const std::string folder = std::string(arguments[1]) + "/";
    for (std::string name : {"rational-128", "rational-256"}) {
        const Exact exact = read_exact(folder + name, 1 << 20);
        size_t count;
        const double naive = count_acute(rounded(exact), count);
        print("doubles in C++, no proof", name, exact.rows.size(), count, naive, "ns each");
        measure<mpq_class>("GMP mpq", name, exact, [](const auto &texts) { return mpq_class(texts[0]); });
        measure<Fmpq>("FLINT fmpq", name, exact, [](const auto &texts) {
            Fmpq value;
            fmpq_set_str(value.x, texts[0].c_str(), 10);
            return value;
        });
    }
    for (std::string name : {"degree-2", "degree-4", "degree-8"}) {
        const Exact exact = read_exact(folder + name, 1 << 20);
        std::ostringstream root;
        root.precision(12);
        root << exact.root << " +/- 1e-9";
        size_t count;
        const double naive = count_acute(rounded(exact), count);
        print("doubles in C++, no proof", name, exact.rows.size(), count, naive, "ns each");
        const auto field = eantic::renf_class::make(written(exact.polynomial), "a", root.str());
        measure<eantic::renf_elem_class>("e-antic", name, exact, [&](const auto &texts) {
            std::vector<mpq_class> coefficients;
            for (const auto &text : texts) coefficients.emplace_back(text);
            return eantic::renf_elem_class(*field, coefficients);
        });
    }
}
