#!/usr/bin/env python3
"""Second checker of certificates: check.py FILE..., exact fractions of the standard library and nothing else.

It reads the format of experiments/verifier/README.md on its own: no line is shared with `subdivlab verify`.
Prints one line a file, "ID: proved" or "ID: rejected: why"; exit code 1 when one is rejected."""
import ast, csv, hashlib, itertools, math, os, re, sys
from fractions import Fraction as Q

DATA = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', '..', 'experiments', 'data')
sys.setrecursionlimit(20000)
class Rejected(Exception): pass
def need(condition, why):
    if not condition: raise Rejected(why)

# ---- Rational functions: Laurent polynomials {((name, power), ..): coefficient} over Laurent polynomials --------------
ONE = {(): Q(1)}
def p_mul(a, b):
    if len(a) > len(b): a, b = b, a
    r = {}
    for m, x in a.items():
        for n, y in b.items():
            if m and n:
                d = dict(m)
                for v, e in n: d[v] = d.get(v, 0) + e
                k = tuple(sorted((v, e) for v, e in d.items() if e))
            else: k = m or n
            r[k] = r.get(k, 0) + x * y
    return {k: c for k, c in r.items() if c}
def p_add(a, b):
    r = dict(a)
    for k, c in b.items(): r[k] = r.get(k, 0) + c
    return {k: c for k, c in r.items() if c}

class F:
    """num / den; den is ONE unless division by more than a monomial was asked for."""
    def __init__(self, num, den=ONE):
        if len(den) == 1 and den is not ONE:  # a monomial goes up
            (k, c), = den.items()
            num, den = p_mul(num, {tuple((v, -e) for v, e in k): 1 / c}), ONE
        self.num, self.den = num, den
    def __add__(self, o):
        if self.den == o.den: return F(p_add(self.num, o.num), self.den)
        return F(p_add(p_mul(self.num, o.den), p_mul(o.num, self.den)), p_mul(self.den, o.den))
    def __neg__(self): return F({k: -c for k, c in self.num.items()}, self.den)
    def __sub__(self, o): return self + -o
    def __mul__(self, o): return F(p_mul(self.num, o.num), self.den if o.den is ONE else p_mul(self.den, o.den))
    def __truediv__(self, o):
        need(o.num, 'division by zero')
        return F(p_mul(self.num, o.den), p_mul(self.den, o.num))
def const(q): return F({(): Q(q)} if q else {})
def var(name): return F({((name, 1),): Q(1)})
def number(f):
    need(isinstance(f, F) and f.den == ONE and set(f.num) <= {()}, 'a number is needed here')
    return f.num.get((), Q(0))
def whole(f):
    q = number(f)
    need(q.denominator == 1, 'a whole number is needed here')
    return q.numerator
def power(f, n):
    r, f = const(1), f if n >= 0 else const(1) / f
    for _ in range(abs(n)): r = r * f
    return r
def by_power(poly, x):  # {exponent of x: polynomial in the others}
    r = {}
    for k, c in poly.items():
        e = dict(k).get(x, 0)
        r.setdefault(e, {})[tuple(t for t in k if t[0] != x)] = c
    return r
def substitute(f, x, by):
    def in_poly(poly):
        return sum((F(rest) * power(by, e) for e, rest in by_power(poly, x).items()), const(0))
    return in_poly(f.num) / in_poly(f.den)
def derivative(f, x):
    d = lambda p: F({k: c for e, rest in by_power(p, x).items() if e
                     for k, c in p_mul(rest, {((x, e - 1),) if e != 1 else (): Q(e)}).items()})
    return d(f.num) if f.den == ONE else (d(f.num) * F(f.den) - F(f.num) * d(f.den)) / (F(f.den) * F(f.den))

# ---- Values: F or lists --------------------------------------------------------------------------------------------
def each(f, a, b):
    if isinstance(a, list) and isinstance(b, list):
        need(len(a) == len(b), 'lists of different lengths')
        return [each(f, x, y) for x, y in zip(a, b)]
    need(not isinstance(a, list) and not isinstance(b, list), 'a list and a number')
    return f(a, b)
def times(a, b):
    if isinstance(a, F): return [times(a, x) for x in b] if isinstance(b, list) else a * b
    if isinstance(b, F): return [times(x, b) for x in a]
    if isinstance(a[0], list): return [times(row, b) for row in a]  # matrix times vector or matrix
    if isinstance(b[0], list): return [times(a, list(column)) for column in zip(*b)]
    need(len(a) == len(b), 'lists of different lengths')
    return sum((x * y for x, y in zip(a, b)), const(0))
def determinant(m):  # Laplace along the first row, by subsets of columns
    n = len(m); need(all(len(r) == n for r in m), 'a square matrix is needed')
    best = {0: const(1)}
    for row in m:
        new = {}
        for used, d in best.items():
            for j in range(n):
                if not used >> j & 1 and row[j].num:
                    term = d * row[j] if bin(used >> j).count('1') % 2 == 0 else -(d * row[j])
                    new[used | 1 << j] = new.get(used | 1 << j, const(0)) + term
        best = new
    return best.get((1 << n) - 1, const(0))

def read_data(name):
    need(re.fullmatch(r'[\w-]+\.csv', name), 'a data file is NAME.csv')
    with open(os.path.join(DATA, name)) as file: rows = [r for r in csv.reader(file) if r and not r[0].startswith('#')]
    head, rows = (rows[0], rows[1:]) if re.match('[a-z]', rows[0][0]) else ([], rows)
    value = lambda row: [const(Q(x.strip())) for x in row]
    if head[:1] != ['polygon']: return [value(r) for r in rows]
    return [[value(r[1:]) for r in group] for _, group in itertools.groupby(rows, lambda r: r[0])]

class Certificate:
    def __init__(self, lines):
        self.names, self.functions, self.boxes, self.roots, self.proof = {}, {}, {}, {}, []
        self.lines, self.values = lines, []

    def parse(self, text):
        text = re.sub(r'(\d+)\.(\d+)', lambda m: f'({int(m[1] + m[2])}/{10 ** len(m[2])})', text).replace('^', '**')
        text = re.sub(r'\bif\(', 'if_(', text)
        try: return ast.parse(text.strip(), mode='eval').body
        except SyntaxError: raise Rejected('no expression: ' + text)
    def value(self, text): return self.evaluate(self.parse(text), {})
    def evaluate(self, t, local):
        go = lambda x: self.evaluate(x, local)
        if isinstance(t, ast.Constant) and type(t.value) is int: return const(t.value)
        if isinstance(t, ast.Name):
            return local[t.id] if t.id in local else self.names[t.id] if t.id in self.names else var(t.id)
        if isinstance(t, ast.List): return [go(x) for x in t.elts]
        if isinstance(t, ast.Subscript): 
            a, i = go(t.value), whole(go(t.slice))
            need(isinstance(a, list) and 0 <= i < len(a), 'index outside the list')
            return a[i]
        if isinstance(t, ast.UnaryOp) and isinstance(t.op, ast.USub): return times(const(-1), go(t.operand))
        if isinstance(t, ast.BinOp):
            a, b, op = go(t.left), go(t.right), type(t.op)
            if op is ast.Add: return each(lambda x, y: x + y, a, b)
            if op is ast.Sub: return each(lambda x, y: x - y, a, b)
            if op is ast.Mult: return times(a, b)
            if op is ast.Div: return times(const(1) / b, a)
            if op is ast.Pow: return power(a, whole(b))
        if isinstance(t, ast.Call) and isinstance(t.func, ast.Name) and not t.keywords: return self.call(t.func.id, t.args, local)
        raise Rejected('not in the language: ' + ast.dump(t)[:60])
    def call(self, name, args, local):
        go = lambda x: self.evaluate(x, local)
        if name in self.functions:
            parameters, body = self.functions[name]
            need(len(parameters) == len(args), 'number of arguments of ' + name)
            return self.evaluate(body, dict(zip(parameters, map(go, args))))
        if name == 'if_': return go(args[1] if number(go(args[0])) else args[2])
        if name in ('seq', 'sum'):
            items = [self.evaluate(args[3], {**local, args[0].id: const(i)}) for i in range(whole(go(args[1])), whole(go(args[2])) + 1)]
            if name == 'seq': return items
            total = items[0] if items else const(0)
            for x in items[1:]: total = each(lambda a, b: a + b, total, x)
            return total
        if name in ('coef', 'subst', 'diff', 'low', 'high'):
            f, x = go(args[0]), args[1].id
            if name == 'diff': return derivative(f, x)
            if name == 'subst': return substitute(f, x, go(args[2]))
            need(all(x not in dict(k) for k in f.den), name + ' of a quotient')
            parts = by_power(f.num, x)
            if name == 'coef': return F(parts.get(whole(go(args[2])), {}), f.den)
            return const(min(parts) if name == 'low' else max(parts))
        v = [go(x) for x in args]
        if name == 'det': return determinant(v[0])
        if name == 'len': return const(len(v[0]))
        if name == 'join': return v[0] + v[1]
        if name == 'abs': return const(abs(number(v[0])))
        if name == 'less': return const(number(v[0]) < number(v[1]))
        if name == 'mod': return const(number(v[0]) % number(v[1]))
        if name == 'floor': return const(math.floor(number(v[0])))
        if name in ('max', 'min'): return const({'max': max, 'min': min}[name](map(number, v[0])))
        raise Rejected('unknown function ' + name)

    # ---- Identities and signs over the boxes of the variables; roots obey their equations ---------------------------
    def reduced(self, poly):
        for x, equation in self.roots.items():
            degree = max(equation)
            while True:
                parts = by_power(poly, x)
                top = max(parts, default=0)
                need(min(parts, default=0) >= 0, 'negative power of a root')
                if top < degree: break
                for e, c in equation.items():
                    shift = {((x, e + top - degree),) if e + top > degree else (): -c / equation[degree]}
                    poly = p_add(poly, p_mul(parts[top], shift))
        return poly
    def equal(self, a, b):
        if isinstance(a, list) or isinstance(b, list):
            return isinstance(a, list) and isinstance(b, list) and len(a) == len(b) and all(map(self.equal, a, b))
        for f in (a, b):
            if any(v in self.roots for k in f.den for v, _ in k): self.cover('definite', [F(self.reduced(f.den))], const(0), '.')
        d = a - b
        low = min((e for k in d.num for _, e in k), default=0)  # roots are not zero where they are divided by
        if low < 0 and self.roots:
            for x in self.roots: d = d * power(var(x), -low)
        return not self.reduced(d.num)
    def bernstein(self, poly, xs, degrees):
        """Coefficients by index over the box, of the degrees; intervals to infinity become u / (1 - u)."""
        table = {}
        for k, c in poly.items(): table[tuple(dict(k).get(x, 0) for x in xs)] = c
        for axis, (x, n) in enumerate(zip(xs, degrees)):
            lo, hi = self.boxes[x][:2]
            new = {}
            for index, c in table.items():
                i = index[axis]
                for j in range(i + 1):  # (lo + w u)^i
                    w = 1 if hi is None else hi - lo
                    key = index[:axis] + (j,) + index[axis + 1:]
                    new[key] = new.get(key, 0) + c * math.comb(i, j) * Q(lo) ** (i - j) * Q(w) ** j
            table = {}
            for index, c in new.items():
                j = index[axis]
                if hi is None: targets = [(j, Q(1, math.comb(n, j)))]
                else: targets = [(k, Q(math.comb(k, j), math.comb(n, j))) for k in range(j, n + 1)]
                for k, f in targets:
                    key = index[:axis] + (k,) + index[axis + 1:]
                    table[key] = table.get(key, 0) + c * f
        return {i: table.get(i, Q(0)) for i in itertools.product(*(range(n + 1) for n in degrees))}
    def cover(self, kind, items, bound, tokens, strict=True):
        """kind sign: items[0] > bound; rows: sum |items| < bound; peak: some |item| > bound; definite: never 0."""
        polys = [F(self.reduced(f.num), self.reduced(f.den)) for f in items + [bound]]
        dens = []
        for f in polys:
            if f.den != ONE and f.den not in dens: dens.append(f.den)
        for i, f in enumerate(polys):  # times the square of the common denominator D: an exact product for each
            for d in dens: f = F(p_mul(f.num, d if d == f.den else p_mul(d, d)), f.den)
            polys[i] = F(self.reduced(f.num))
        if dens and not strict:
            for d in dens: self.cover('definite', [F(d)], const(0), '.')
        xs = sorted({v for f in polys for k in f.num for v, _ in k})
        for x in xs: need(x in self.boxes, f'no range for {x}')
        for x in xs:  # even powers of a variable that is not 0 change no sign
            low = min((dict(k).get(x, 0) for f in polys for k in f.num), default=0)
            if low < 0:
                lo, hi = self.boxes[x][:2]
                need(lo > 0 or (hi is not None and hi < 0), f'{x} may be 0 in a denominator')
                polys = [f * power(var(x), -low + (-low) % 2) for f in polys]
        degrees = [max(dict(k).get(x, 0) for f in polys for k in f.num) for x in xs]
        degrees = [max(n, 2) if self.boxes[x][2] and self.boxes[x][3] else n for n, x in zip(degrees, xs)]
        arrays = [self.bernstein(f.num, xs, degrees) for f in polys]
        tokens = tokens.split()
        def excluded(index, ends):
            return any(n and ((e[0] and i == 0) or (e[1] and i == n)) for i, n, e in zip(index, degrees, ends))
        def walk(arrays, ends):
            need(tokens, 'the cover is cut off')
            token = tokens.pop(0)
            if token in xs:
                axis = xs.index(token)
                halves = [self.split(a, axis, degrees) for a in arrays]
                walk([h[0] for h in halves], [(e[0], False) if i == axis else e for i, e in enumerate(ends)])
                walk([h[1] for h in halves], [(False, e[1]) if i == axis else e for i, e in enumerate(ends)])
                return
            *values, top = arrays
            if kind == 'rows': margin = {i: top[i] - sum(abs(v[i]) for v in values) for i in top}
            elif kind == 'peak':
                need(re.fullmatch(r'[+-]\d+', token) and int(token[1:]) < len(values), 'a cell of the cover names no component')
                margin = {i: int(token[0] + '1') * values[int(token[1:])][i] - top[i] for i in top}
            else:
                margin = {i: values[0][i] - top[i] for i in top}
                if kind == 'definite' and margin[next(iter(margin))] < 0: margin = {i: -m for i, m in margin.items()}
            need(kind == 'peak' or token == '.', 'unknown cell ' + token)
            for i, m in margin.items():
                need(m > 0 or (m == 0 and (not strict or (kind != 'definite' and excluded(i, ends)))), f'the sign is not proved on a cell')
        walk(arrays, [self.boxes[x][2:] for x in xs])
        need(not tokens, 'the cover has too many cells')
    def split(self, a, axis, degrees):
        left, right = {}, {}
        for index in a:
            if index[axis]: continue
            line = [a[index[:axis] + (i,) + index[axis + 1:]] for i in range(degrees[axis] + 1)]
            for i in range(degrees[axis] + 1):
                left[index[:axis] + (i,) + index[axis + 1:]] = line[0]
                right[index[:axis] + (degrees[axis] - i,) + index[axis + 1:]] = line[-1]
                line = [(x + y) / 2 for x, y in zip(line, line[1:])]
        return left, right

    # ---- Statements -------------------------------------------------------------------------------------------------
    def next(self, word):
        need(self.proof and self.proof[0].split(' ', 1)[0] == word, f"the proof lacks '{word}'")
        return self.proof.pop(0)[len(word):]
    def compare(self, a, b, strict):  # a > b or a >= b
        if not strict and self.equal(a, b): return
        d = a - b
        constant = d.den == ONE and set(d.num) <= {()}
        need(not constant or number(d) > 0 or (number(d) == 0 and not strict), 'the inequality is false')
        if not constant: self.cover('sign', [d], const(0), self.next('cover'), strict)
    def rows(self, items, bound, strict):
        for row in items if isinstance(items[0], list) else [items]:
            if all(f.den == ONE and set(f.num) <= {()} for f in row + [bound]):
                total = sum(abs(number(f)) for f in row)
                need(total < number(bound) or (total == number(bound) and not strict), 'a sum of absolute values is too large')
            else: self.cover('rows', row, bound, self.next('cover'), strict)
    def interval(self, text):
        m = re.fullmatch(r'\s*([\[(])(.*),(.*)([\])])\s*', text)
        need(m, 'an interval is needed')
        lo, hi = number(self.value(m[2])), None if m[3].strip() == 'inf' else number(self.value(m[3]))
        need((hi is None and m[4] == ')') or (hi is not None and lo <= hi), 'the ends of an interval are reversed')
        return lo, hi, m[1] == '(', m[4] == ')'
    def state(self, line):
        verb, _, rest = line.partition(' ')
        if verb == 'let':
            name, _, text = rest.partition('=')
            need(name.strip() not in self.names, 'named twice')
            self.names[name.strip()] = self.value(text)
        elif verb == 'def':
            m = re.fullmatch(r'(\w+)\((.*?)\) = (.*)', rest)
            self.functions[m[1]] = ([p.strip() for p in m[2].split(',') if p.strip()], self.parse(m[3]))
        elif verb == 'for':
            x, _, text = rest.partition(' in ')
            need(x not in self.roots, 'a root has its range')
            self.boxes[x] = self.interval(text)
        elif verb == 'root':
            m = re.fullmatch(r'(\w+) of (.*) in (\[[^\[]*\])', rest)
            x, f = m[1], self.value(m[2])
            need(x not in self.boxes and x not in self.names and f.den == ONE, 'a root of a polynomial is needed')
            equation = {e: number(F(c)) for e, c in by_power(f.num, x).items()}
            self.boxes[x] = lo, hi, _, _ = self.interval(m[3])
            need(min(equation) >= 0 and number(substitute(f, x, const(lo))) * number(substitute(f, x, const(hi))) < 0, 'no change of sign')
            self.cover('definite', [derivative(f, x)], const(0), self.next('cover'))
            self.roots[x] = equation
        elif verb == 'value': self.values.append(self.value(rest))
        elif verb == 'rows':
            a, relation, b = re.split(r' (<=?) ', rest)
            self.rows(self.value(a), self.value(b), relation == '<')
        elif verb == 'peak':
            a, b = rest.split(' > ')
            self.cover('peak', self.value(a), self.value(b), self.next('cover'))
        elif verb == 'radius': self.radius(*re.split(r' ([<>]=) ', rest))
        elif verb == 'least': self.least(*re.fullmatch(r'(max|sum) (.*) over (.*) == (.*) at (.*)', rest).groups())
        elif verb == 'minimum': self.minimum(*re.fullmatch(r'max (.*) over (.*) == (.*) at (.*)', rest).groups())
        else:
            a, relation, b = re.fullmatch(r'(.*) (==|!=|>=?) (.*)', line).groups()
            a, b = self.value(a), self.value(b)
            if relation == '==': need(self.equal(a, b), 'the two sides are not equal')
            elif relation == '!=': self.compare((a - b) * (a - b), const(0), True)
            else: self.compare(a, b, relation == '>')
    def radius(self, family, relation, bound):
        family, bound = self.value(family), self.value(bound)
        if relation == '<=':  # the balanced hull of the vertices is mapped into `bound` times itself
            vertices, images = self.value(self.next('vertices')), self.value(self.next('images'))
            span = [vertices[whole(k)] for k in self.value(self.next('span'))]
            need(len(span) == len(family[0]), 'the vertices do not span the space')
            self.compare(power(determinant(span), 2), const(0), True)
            need(len(images) == len(family) * len(vertices), 'an image is missing')
            for (m, v), weights in zip(itertools.product(family, vertices), images):
                need(self.equal(times(m, v), times(weights, vertices)), 'an image is not that combination')
            self.rows(images, bound, False)
        else:  # det of the product on an invariant space of dimension d is the product of d eigenvalues
            word, space, block = self.value(self.next('word')), self.value(self.next('space')), self.value(self.next('block'))
            product = family[whole(word[0])]
            for k in word[1:]: product = times(product, family[whole(k)])
            need(self.equal(times(product, space), times(space, block)), 'the space is not invariant')
            self.compare(determinant(times([list(c) for c in zip(*space)], space)), const(0), True)
            self.compare(power(determinant(block), 2), power(bound, 2 * len(word) * len(block)), False)
    def least(self, norm, items, over, value, at):
        """Affine items: weights that cancel the variables bound the norm from below by a constant, reached at `at`."""
        items, xs, value, at = self.value(items), [x.strip() for x in over.split(',')], self.value(value), self.value(at)
        dual, at = self.value(self.next('dual')), at if isinstance(at, list) else [at]
        need(len(dual) == len(items) and len(at) == len(xs), 'a weight for each item, a place for each variable')
        self.rows([dual] if norm == 'max' else [[y] for y in dual], const(1), False)
        combined, there = times(dual, items), items
        for x, place in zip(xs, at):
            need(self.equal(derivative(combined, x), const(0)), 'the weights leave a variable')
            there = [substitute(f, x, place) for f in there]
        need(self.equal(combined, value), 'the weights give another bound')
        self.rows([[f] for f in there] if norm == 'max' else there, value, False)
    def minimum(self, items, x, value, at):
        """Of max |item| over the range of x: beyond [a, b] an item exceeds the value; on both sides of `at` within it one
        falls, or rises, from the value at `at` (signs and numbers of the two items)."""
        items, value, at = self.value(items), self.value(value), self.value(at)
        box, (lo, hi), (i, j) = self.boxes[x], self.interval(self.next('near'))[:2], self.next('active').split()
        pick = lambda t: items[int(t[1:])] if t[0] == '+' else -items[int(t[1:])]
        there = [substitute(f, x, at) for f in items]
        for f in there:
            self.compare(value, f, False)
            self.compare(value, -f, False)
        need(self.equal(substitute(pick(i), x, at), value) and self.equal(substitute(pick(j), x, at), value), 'not active')
        self.boxes[x] = lo, hi, False, False
        self.compare(-derivative(pick(i), x), const(0), True)
        self.compare(derivative(pick(j), x), const(0), True)
        self.compare(at, const(lo), True)
        self.compare(const(hi), at, True)
        for side in ((box[0], lo, box[2], False), (hi, box[1], False, box[3])):
            self.boxes[x] = side
            if side[0] < side[1]: self.cover('peak', items, value, self.next('cover'))
        self.boxes[x] = box

# ---- Schemes and files -----------------------------------------------------------------------------------------------
def catalogue(text, c):
    family, _, rest = text.partition(':')
    args = {k.strip(): c.value(v) for k, _, v in (p.partition('=') for p in rest.split(',') if p)}
    z, n = var('z'), lambda p, q=1: const(Q(p, q))
    row = lambda first, coefficients: sum((f * power(z, first + i) for i, f in enumerate(coefficients)), n(0))
    if family == 'jspline':
        a, b = args.get('a', args.get('s')), args.get('b', args.get('s'))
        o, e = (b - n(1)) * n(1, 16), a * n(1, 8)
        return row(-3, [o, e, n(1, 2) - o, n(1) - e - e, n(1, 2) - o, e, o])
    if family == 'four-point':
        w = args.get('w', n(1, 16))
        return row(-3, [-w, n(0), n(1, 2) + w, n(1), n(1, 2) + w, n(0), -w])
    if family == 'dyn-floater-hormann':
        w = args['w'] if 'w' in args else n(1, 128)
        half = [n(-5) * w, n(-7) * w, n(1, 4) + n(3) * w, n(3, 4) + n(9) * w]
        return row(-4, half + half[::-1])
    if family == 'bspline':
        d = whole(args['degree'])
        return row(-((d + 1) // 2), [n(math.comb(d + 1, i), 2 ** d) for i in range(d + 2)])
    if family == 'deslauriers-dubuc':
        k = whole(args['points']) // 2
        w = lambda j: math.prod(Q(1 - 2 * i, 2 * (j - i)) for i in range(1 - k, k + 1) if i != j)
        return n(1) + sum((n(w(j)) * power(z, 1 - 2 * j) for j in range(1 - k, k + 1)), n(0))
    return None  # a file: the mask in the header says which scheme is meant
def check(text):
    lines = text.split('\n')
    need(text.endswith('\n') and lines[0] == 'subdivlab certificate 1' and lines[-2] == 'end', 'no whole certificate')
    need(lines.count('statement') == 1 and lines.count('proof') == 1, 'no statement or no proof')
    s, p = lines.index('statement'), lines.index('proof')
    need(s < p and lines[1].startswith('claim ') and lines[2].startswith('digest '), 'the head is out of order')
    head = lines[3:s]
    digest = hashlib.sha256('\n'.join([lines[1]] + lines[3:p] + ['']).encode()).hexdigest()
    need(lines[2] == 'digest ' + digest, 'the digest is that of another scheme or statement')
    c = Certificate(lines)
    c.proof = lines[p + 1:-2]
    for line in head:
        if line.startswith('scheme '):
            name, scheme, mask = re.fullmatch(r'scheme (\w+) (\S+) = (.*)', line).groups()
            c.names[name] = c.value(mask)
            known = catalogue(scheme, c)
            need(known is None or c.equal(known, c.names[name]), 'this is not the mask of ' + scheme)
        elif line.startswith('data '):
            name, file, digest = line.split()[1:]
            with open(os.path.join(DATA, file), 'rb') as f: need(hashlib.sha256(f.read()).hexdigest() == digest, 'other data')
            c.names[name] = read_data(file)
        else: raise Rejected('unknown line of the head: ' + line)
    need(p > s + 1, 'nothing is stated')
    for line in lines[s + 1:p]:
        try: c.state(line)
        except (ValueError, AttributeError, IndexError, KeyError, ZeroDivisionError, TypeError, RecursionError) as e:
            raise Rejected(f'malformed: {line}: {e!r}')
        except Rejected as e: raise Rejected(f'{e} ({line})')
    need(not c.proof, 'the proof says more than is stated')
    return lines[1][6:], c.values

if __name__ == '__main__':
    status = 0
    for name in sys.argv[1:]:
        with open(name, encoding='utf-8', newline='') as file: text = file.read()
        try: print(f'{check(text)[0]}: proved')
        except Rejected as why:
            status, _ = 1, print(f'{name}: rejected: {why}')
    sys.exit(status)
