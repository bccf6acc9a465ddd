// std::sort: facets of tetrahedra matched by sorting them, beside a copy of their bytes.
//   matching DIRECTORY
#include "acute.hpp"
#include <cstring>
#include <tuple>

struct Facet {
    uint32_t a, b, c, tetrahedron;
    bool operator<(const Facet &o) const { return std::tie(a, b, c) < std::tie(o.a, o.b, o.c); }
    bool same(const Facet &o) const { return a == o.a && b == o.b && c == o.c; }
};

int main(int, char **arguments) {
    std::ifstream file(std::string(arguments[1]) + "/matching", std::ios::binary | std::ios::ate);
    std::vector<std::array<uint32_t, 4>> tetrahedra(file.tellg() / 16);
    file.seekg(0).read(reinterpret_cast<char *>(tetrahedra.data()), tetrahedra.size() * 16);
    std::vector<Facet> facets(4 * tetrahedra.size()), copy(facets.size());
    size_t pairs = 0;
    const auto match = [&] {
        for (size_t t = 0; t < tetrahedra.size(); t++)
            for (int k = 0; k < 4; k++) {
                uint32_t v[3];
                for (int i = 0, n = 0; i < 4; i++)
                    if (i != k) v[n++] = tetrahedra[t][i];
                std::sort(v, v + 3);
                facets[4 * t + k] = {v[0], v[1], v[2], uint32_t(t)};
            }
        std::sort(facets.begin(), facets.end());
        pairs = 0;
        for (size_t i = 0; i + 1 < facets.size(); i += 2) pairs += facets[i].same(facets[i + 1]);
    };
    const double seconds = fastest(match);
    const double copied = fastest([&] { std::memcpy(copy.data(), facets.data(), facets.size() * sizeof(Facet)); });
    print("std::sort", "matching", facets.size(), pairs, seconds, "s");
    print("std::sort", "matching", facets.size(), pairs, seconds / copied, "x memcpy");
}
