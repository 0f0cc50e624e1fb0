#!/usr/bin/env python3
"""Second checker of certificates: check.py FILE..., in exact fractions, with the standard library alone.

It reads experiments/certificates/README.md's format on its own: no line is shared with `subdivlab verify`. Prints
"ID: proved" or "FILE: rejected: why" for each file; exit code 1 when one is rejected."""
import ast, csv, hashlib, itertools, math, os, re, sys
from fractions import Fraction as Q

DATA = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', '..', 'experiments', 'data')
sys.setrecursionlimit(20000)
class Rejected(Exception): pass
def need(condition, why):
    if not condition: raise Rejected(why)

# ---- Rational functions: Laurent polynomials {((name, power), ..): coefficient} over Laurent polynomials -------------
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
    """num / den; a denominator of one term is moved into num, and den is ONE then."""
    def __init__(self, num, den=ONE):
        if len(den) == 1 and den is not ONE:
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
    def is_number(self): return self.den == ONE and set(self.num) <= {()}
def const(q): return F({(): Q(q)} if q else {})
def var(name): return F({((name, 1),): Q(1)})
def number(f):
    need(isinstance(f, F) and f.is_number(), 'a number is needed here')
    return f.num.get((), Q(0))
def whole(f):
    need(number(f).denominator == 1, 'a whole number is needed here')
    return number(f).numerator
def power(f, n):
    need(isinstance(f, F) and abs(n) <= 100000, 'a power of a number is needed')
    r, f = const(1), f if n >= 0 else const(1) / f
    for _ in range(abs(n)): r = r * f
    return r
def by_power(poly, x):  # {power of x: polynomial in the others}
    r = {}
    for k, c in poly.items(): r.setdefault(dict(k).get(x, 0), {})[tuple(t for t in k if t[0] != x)] = c
    return r
def substitute(f, x, by):
    inside = lambda poly: sum((F(rest) * power(by, e) for e, rest in by_power(poly, x).items()), const(0))
    return inside(f.num) / inside(f.den)
def derivative(f, x):
    d = lambda p: sum((const(e) * F(rest) * power(var(x), e - 1) for e, rest in by_power(p, x).items() if e), const(0))
    return d(f.num) if f.den == ONE else (d(f.num) * F(f.den) - F(f.num) * d(f.den)) / (F(f.den) * F(f.den))

# ---- Values: F or lists ----------------------------------------------------------------------------------------------
def each(f, a, b):
    need(isinstance(a, list) == isinstance(b, list), 'a list and a number')
    if not isinstance(a, list): return f(a, b)
    need(len(a) == len(b), 'lists of different lengths')
    return [each(f, x, y) for x, y in zip(a, b)]
def plus(a, b): return each(lambda x, y: x + y, a, b)
def columns(m):
    need(m and all(isinstance(row, list) and len(row) == len(m[0]) for row in m), 'rows of different lengths')
    return [list(c) for c in zip(*m)]
def times(a, b):
    if isinstance(a, F): return [times(a, x) for x in b] if isinstance(b, list) else a * b
    if isinstance(b, F): return [times(x, b) for x in a]
    if isinstance(a[0], list): return [times(row, b) for row in a]
    if isinstance(b[0], list): return [times(a, list(column)) for column in columns(b)]
    need(len(a) == len(b), 'lists of different lengths')
    return sum((x * y for x, y in zip(a, b)), const(0))
def determinant(m):  # Laplace's expansion row by row, the sum kept by the set of columns used
    minors = {0: const(1)}
    for row in m:
        need(len(row) == len(m), 'a square matrix is needed')
        new = {}
        for (used, d), (j, x) in itertools.product(minors.items(), enumerate(row)):
            if used >> j & 1 or not x.num: continue
            term = d * x if bin(used >> j).count('1') % 2 == 0 else -(d * x)
            new[used | 1 << j] = new.get(used | 1 << j, const(0)) + term
        minors = new
    return minors.get((1 << len(m)) - 1, const(0))
def read_data(name):
    need(re.fullmatch(r'[\w-]+\.csv', name), 'a data file is NAME.csv')
    with open(os.path.join(DATA, name)) as file: rows = [r for r in csv.reader(file) if r and not r[0].startswith('#')]
    head, rows = (rows[0], rows[1:]) if re.match('[a-z]', rows[0][0]) else ([], rows)
    value = lambda row: [const(Q(x.strip())) for x in row]
    if head[:1] != ['polygon']: return [value(r) for r in rows]
    return [[value(r[1:]) for r in group] for _, group in itertools.groupby(rows, lambda r: r[0])]
COUNT = {'if': 3, 'seq': 4, 'sum': 4, 'coef': 3, 'subst': 3, 'diff': 2, 'low': 2, 'high': 2, 'det': 1, 'len': 1, 'join': 2,
         'less': 2, 'abs': 1, 'mod': 2, 'floor': 1, 'max': 1, 'min': 1}  # arguments of the language's own functions
TOKEN = re.compile(r' *(?:(\d+)(?:\.(\d+))?(?!\w)|([A-Za-z_]\w*)|([-+*/^()\[\],])) *', re.ASCII)
def parse(text):  # as an expression of Python's: ** for ^, quotients for decimals, an underscore after each name
    need(re.fullmatch(f'(?:{TOKEN.pattern})+', text, re.ASCII) and not re.search(r', *[])]', text), 'no expression: ' + text)
    word = lambda m: f'({int(m[1] + (m[2] or ""))}/{10 ** len(m[2] or "")})' if m[1] else m[3] + '_' if m[3] else m[4].replace('^', '**')
    try: return ast.parse(' '.join(map(word, TOKEN.finditer(text))), mode='eval').body
    except (SyntaxError, MemoryError): raise Rejected('no expression: ' + text)

class Checker:
    def __init__(self): self.names, self.functions, self.boxes, self.roots, self.proof, self.values = {}, {}, {}, {}, [], []
    def value(self, text): return self.evaluate(parse(text), {})
    def evaluate(self, t, local):
        go = lambda x: self.evaluate(x, local)
        if isinstance(t, ast.Constant) and type(t.value) is int: return const(t.value)
        if isinstance(t, ast.Name):
            x = t.id[:-1]
            scope = local if x in local else self.names
            return scope[x] if x in scope else var(x)
        if isinstance(t, ast.List): return [go(x) for x in t.elts]
        if isinstance(t, ast.Subscript):
            a, i = go(t.value), whole(go(t.slice))
            need(isinstance(a, list) and 0 <= i < len(a), 'an index is outside its list')
            return a[i]
        if isinstance(t, ast.UnaryOp) and isinstance(t.op, ast.USub): return times(const(-1), go(t.operand))
        if isinstance(t, ast.BinOp):
            a, b, op = go(t.left), go(t.right), type(t.op)
            if op is ast.Add: return plus(a, b)
            if op is ast.Sub: return plus(a, times(const(-1), b))
            if op is ast.Mult: return times(a, b)
            if op is ast.Div: return times(const(1) / b, a)
            if op is ast.Pow: return power(a, whole(b))
        need(isinstance(t, ast.Call) and isinstance(t.func, ast.Name) and not t.keywords, 'not in the language')
        return self.call(t.func.id[:-1], t.args, local)
    def call(self, name, args, local):
        go = lambda x: self.evaluate(x, local)
        if name in self.functions:
            parameters, body = self.functions[name]
            need(len(parameters) == len(args), 'the number of arguments of ' + name)
            return self.evaluate(body, dict(zip(parameters, map(go, args))))
        need(COUNT.get(name) == len(args), 'the number of arguments of ' + name)
        if name == 'if': return go(args[1] if number(go(args[0])) else args[2])
        if name in ('seq', 'sum'):
            numbers = range(whole(go(args[1])), whole(go(args[2])) + 1)
            items = [self.evaluate(args[3], {**local, args[0].id[:-1]: const(i)}) for i in numbers]
            if name == 'seq': return items
            total = items[0] if items else const(0)
            for x in items[1:]: total = plus(total, x)
            return total
        if name in ('coef', 'subst', 'diff', 'low', 'high'):
            f, x = go(args[0]), args[1].id[:-1]
            need(isinstance(f, F) and not any(x in known for known in (local, self.names, self.roots)), x + ' is no indeterminate')
            if name == 'diff': return derivative(f, x)
            if name == 'subst': return substitute(f, x, go(args[2]))
            need(all(x not in dict(k) for k in f.den), name + ' of a quotient')
            parts = by_power(f.num, x)
            if name == 'coef': return F(parts.get(whole(go(args[2])), {}), f.den)
            need(not any(v in self.roots for k in f.num for v, _ in k), name + ' of a polynomial with roots')
            return const(min(parts) if name == 'low' else max(parts))
        v = [go(x) for x in args]
        if name == 'det': return determinant(v[0])
        if name == 'len': return const(len(v[0]))
        need(name != 'join' or all(isinstance(x, list) for x in v), 'a list is needed')
        if name == 'join': return v[0] + v[1]
        if name in ('max', 'min'): return const({'max': max, 'min': min}[name](map(number, v[0])))
        known = {'abs': abs, 'floor': math.floor, 'less': lambda a, b: a < b, 'mod': lambda a, b: a % b}
        return const(known[name](*map(number, v)))

    # ---- Identities and signs over the boxes of the variables; roots obey their equations ----------------------------
    def reduced(self, poly):
        for x, equation in self.roots.items():
            while True:
                parts, degree = by_power(poly, x), max(equation)
                top = max(parts, default=0)
                if top < degree: break
                need(min(parts) >= 0, 'a negative power of a root')
                for e, c in equation.items():
                    poly = p_add(poly, (F(parts[top]) * power(var(x), e + top - degree) * const(-c / equation[degree])).num)
        return poly
    def equal(self, a, b):
        if isinstance(a, list) or isinstance(b, list):
            return isinstance(a, list) and isinstance(b, list) and len(a) == len(b) and all(map(self.equal, a, b))
        for f in (a, b):
            if any(v in self.roots for k in f.den for v, _ in k): self.cover('nonzero', [F(self.reduced(f.den))], const(0), '.')
        d = a - b
        for x in self.roots:
            low = min(by_power(d.num, x), default=0)
            if low < 0: need(self.boxes[x][0] > 0 or self.boxes[x][1] < 0, f'{x} may be 0 in a denominator')
            d = d * power(var(x), max(-low, 0))
        return not self.reduced(d.num)
    def bernstein(self, poly, xs, degrees):
        """Bernstein coefficients over the box by index; over [lo, inf) of (1-u)^n p(lo + u/(1-u))."""
        table = {tuple(dict(k).get(x, 0) for x in xs): c for k, c in poly.items()}
        for axis, (x, n) in enumerate(zip(xs, degrees)):
            lo, hi = self.boxes[x][:2]
            for step in range(2):  # the powers of u, then its Bernstein polynomials
                new = {}
                for index, c in table.items():
                    i = index[axis]
                    if step == 0: to = [(j, math.comb(i, j) * lo ** (i - j) * (1 if hi is None else hi - lo) ** j) for j in range(i + 1)]
                    elif hi is None: to = [(i, Q(1, math.comb(n, i)))]
                    else: to = [(k, Q(math.comb(k, i), math.comb(n, i))) for k in range(i, n + 1)]
                    for j, f in to: new[index[:axis] + (j,) + index[axis + 1:]] = new.get(index[:axis] + (j,) + index[axis + 1:], 0) + c * f
                table = new
        return {i: table.get(i, Q(0)) for i in itertools.product(*(range(n + 1) for n in degrees))}
    def cover(self, kind, items, bound, tokens, strict=True):
        """sign: items[0] > bound; rows: sum |items| < bound; peak: some |item| > bound; nonzero: items[0] is never 0."""
        polys, dens = items + [bound], []
        for f in polys:
            if f.den != ONE and f.den not in dens: dens.append(f.den)
        for i, f in enumerate(polys):  # times the square of the product of all denominators
            for d in dens: f = F(p_mul(f.num, d if d == f.den else p_mul(d, d)), f.den)
            polys[i] = F(self.reduced(f.num))
        for d in () if strict else dens: self.cover('nonzero', [F(self.reduced(d))], const(0), '.')
        xs = sorted({v for f in polys for k in f.num for v, _ in k})
        for x in xs:  # even powers of a variable that is not 0 change no sign
            need(x in self.boxes, f'no range for {x}')
            low = min(dict(k).get(x, 0) for f in polys for k in f.num)
            if low < 0:
                need(self.boxes[x][0] > 0 or (self.boxes[x][1] is not None and self.boxes[x][1] < 0), f'{x} may be 0 in a denominator')
                polys = [f * power(var(x), -low + (-low) % 2) for f in polys]
        degrees = [max(dict(k).get(x, 0) for f in polys for k in f.num) for x in xs]
        tokens = tokens.split()
        self.walk(kind, strict, xs, degrees, [self.bernstein(f.num, xs, degrees) for f in polys], [self.boxes[x][2:] for x in xs], tokens)
        need(not tokens, 'the cover has too many cells')
    def walk(self, kind, strict, xs, degrees, arrays, ends, tokens):
        need(tokens, 'the cover is cut off')
        token = tokens.pop(0)
        if token in xs:
            axis = xs.index(token)
            pairs = [split(a, axis, degrees) for a in arrays]
            for side in (0, 1):
                inner = [(e[0] and not side, e[1] and bool(side)) if i == axis else e for i, e in enumerate(ends)]
                self.walk(kind, strict, xs, degrees, [p[side] for p in pairs], inner, tokens)
            return
        need(token == '.' if kind != 'peak' else re.fullmatch(r'[+-]\d{1,6}', token) and int(token[1:]) < len(arrays) - 1, 'unknown cell ' + token)
        *values, top = arrays
        first = next((x for x in values[0].values() if x), 0)
        sign = -1 if token[0] == '-' or (kind == 'nonzero' and first < 0) else 1
        entry = values[int(token[1:]) if kind == 'peak' else 0]
        margin = {i: top[i] - sum(abs(v[i]) for v in values) if kind == 'rows' else sign * entry[i] - top[i] for i in top}
        need(all(m >= 0 for m in margin.values()), 'the sign is not proved on a cell')
        for face in itertools.product(*([e for e, out in zip((0, n), end) if not out] or [None] for n, end in zip(degrees, ends))):
            need(not strict or any(m > 0 and all(f in (None, k) for f, k in zip(face, i)) for i, m in margin.items()), 'the sign is not strict on a cell')

    # ---- Statements --------------------------------------------------------------------------------------------------
    def next(self, word):
        need(self.proof and self.proof[0].split(' ', 1)[0] == word, f"the proof lacks '{word}'")
        return self.proof.pop(0)[len(word) + 1:]
    def greater(self, a, b, strict):
        if not strict and self.equal(a, b): return
        if not (a - b).is_number(): return self.cover('sign', [a - b], const(0), self.next('cover'), strict)
        need(number(a - b) > 0 or (number(a - b) == 0 and not strict), 'the inequality is false')
    def rows(self, items, bound, strict):
        for row in items if isinstance(items[0], list) else [items]:
            need(row, 'an empty row')
            if not all(f.is_number() for f in row + [bound]): self.cover('rows', row, bound, self.next('cover'), strict)
            else:
                margin = number(bound) - sum(abs(number(f)) for f in row)
                need(margin > 0 or (margin == 0 and not strict), 'a sum of absolute values is too large')
    def interval(self, text):
        m = re.fullmatch(r'\s*([\[(])(.*),(.*)([\])])\s*', text)
        lo, hi = number(self.value(m[2])), None if m[3].strip() == 'inf' else number(self.value(m[3]))
        need(m[4] == ')' if hi is None else lo < hi or (lo == hi and m[1] + m[4] == '[]'), 'the ends of an interval are reversed')
        return lo, hi, m[1] == '(', m[4] == ')'
    def is_free(self, x): return re.fullmatch(r'[A-Za-z_]\w*', x, re.ASCII) and x not in self.names and x not in self.roots
    def state(self, line):
        verb, _, rest = line.partition(' ')
        if verb == '#': return
        if verb == 'let':
            name, _, text = rest.partition('=')
            need(self.is_free(name.strip()) and name.strip() not in self.boxes, 'named twice')
            self.names[name.strip()] = self.value(text)
        elif verb == 'def':
            m = re.fullmatch(r'(\w+)\((.*?)\) = (.*)', rest)
            need(self.is_free(m[1] + '_') and m[1] not in COUNT and m[1] not in self.functions, 'named twice')
            self.functions[m[1]] = ([p.strip() for p in m[2].split(',') if p.strip()], parse(m[3]))
        elif verb == 'for':
            x, _, text = rest.partition(' in ')
            need(self.is_free(x), x + ' has a value')
            self.boxes[x] = self.interval(text)
        elif verb == 'root':
            m = re.fullmatch(r'(\w+) of (.*) in (\[[^\[]*\])', rest)
            x, f = m[1], self.value(m[2])
            need(self.is_free(x) and x not in self.boxes and f.den == ONE, 'a root of a polynomial is needed')
            equation = {e: number(F(c)) for e, c in by_power(f.num, x).items()}
            lo, hi, *_ = self.boxes[x] = self.interval(m[3])
            change = number(substitute(f, x, const(lo))) * number(substitute(f, x, const(hi)))
            need(min(equation) >= 0 and change < 0, 'no change of sign')
            self.cover('nonzero', [derivative(f, x)], const(0), self.next('cover'))
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
            a, relation, b = re.fullmatch(r'(.*?) (==|!=|>=?) (.*)', line).groups()
            a, b = self.value(a), self.value(b)
            if relation == '==': need(self.equal(a, b), 'the two sides are not equal')
            elif relation == '!=': self.greater((a - b) * (a - b), const(0), True)
            else: self.greater(a, b, relation == '>')
    def radius(self, family, relation, bound):
        family, bound = self.value(family), self.value(bound)
        need(all(len(m) == len(family[0]) == len(row) > 0 and all(isinstance(f, F) for f in row) for m in family for row in m), 'square matrices')
        if relation == '<=':  # the balanced hull of the vertices is sent into `bound` times itself
            vertices, images = self.value(self.next('vertices')), self.value(self.next('images'))
            span = [whole(k) for k in self.value(self.next('span'))]
            need(len(span) == len(family[0]) and all(0 <= k < len(vertices) for k in span), 'the vertices do not span the space')
            self.greater(power(determinant([vertices[k] for k in span]), 2), const(0), True)
            need(len(images) == len(family) * len(vertices), 'an image is missing')
            for (m, v), weights in zip(itertools.product(family, vertices), images):
                need(self.equal(times(m, v), times(weights, vertices)), 'an image is not that combination')
            return self.rows(images, bound, False)
        word = [whole(k) for k in self.value(self.next('word'))]  # on an invariant space det is a product of eigenvalues
        space, block = self.value(self.next('space')), self.value(self.next('block'))
        need(word and all(0 <= k < len(family) for k in word), 'there is no such matrix')
        product = family[word[0]]
        for k in word[1:]: product = times(product, family[k])
        need(self.equal(times(product, space), times(space, block)), 'the space is not invariant')
        self.greater(determinant(times(columns(space), space)), const(0), True)
        self.greater(power(determinant(block), 2), power(bound, 2 * len(word) * len(block)), False)
    def least(self, norm, items, over, value, at):
        """Affine items: weights that cancel the variables bound the norm from below by a constant, reached at `at`."""
        items, xs, value, at = self.value(items), [x.strip() for x in over.split(',')], self.value(value), self.value(at)
        dual, at = self.value(self.next('dual')), at if isinstance(at, list) else [at]
        need(all(self.is_free(x) and x not in self.boxes for x in xs), 'a variable does not run over all numbers')
        need(len(dual) == len(items) and len(at) == len(xs), 'a weight for each entry, a place for each variable')
        column = lambda row: [[f] for f in row]
        self.rows(dual if norm == 'max' else column(dual), const(1), False)
        combined, there = times(dual, items), items
        for x, place in zip(xs, at):
            need(self.equal(derivative(combined, x), const(0)), 'the weights leave a variable')
            there = [substitute(f, x, place) for f in there]
        need(self.equal(combined, value), 'the weights give another bound')
        self.rows(column(there) if norm == 'max' else there, value, False)
    def minimum(self, items, x, value, at):
        """Outside `near` some item exceeds the value; within it one item falls to `at`, another rises from it."""
        items, value, at, box = self.value(items), self.value(value), self.value(at), self.boxes[x]
        (lo, hi, *_), active = self.interval(self.next('near')), self.next('active').split()
        need(len(active) == 2 and all(re.fullmatch(r'[+-]\d{1,6}', t) for t in active) and hi is not None, 'two active items are needed')
        falling, rising = [items[int(t[1:])] if t[0] == '+' else -items[int(t[1:])] for t in active]
        need(self.is_free(x) and lo >= box[0] and (box[1] is None or hi <= box[1]), "'near' leaves the interval")
        need(all(self.equal(derivative(f, x), const(0)) for f in (value, at)), 'the minimum depends on its variable')
        for f in items:
            for there in (substitute(f, x, at), -substitute(f, x, at)): self.greater(value, there, False)
        need(self.equal(substitute(falling, x, at), value) and self.equal(substitute(rising, x, at), value), 'not active')
        self.boxes[x] = lo, hi, False, False
        self.greater(-derivative(falling, x), const(0), True)
        self.greater(derivative(rising, x), const(0), True)
        self.greater(at, const(lo), True)
        self.greater(const(hi), at, True)
        for side in ((box[0], lo, box[2], False), (hi, box[1], False, box[3])):
            self.boxes[x] = side
            if side[1] is None or side[0] < side[1]: self.cover('peak', items, value, self.next('cover'))
        self.boxes[x] = box
def split(a, axis, degrees):  # de Casteljau at the middle
    left, right = {}, {}
    for index in (i for i in a if i[axis] == 0):
        at = lambda k: index[:axis] + (k,) + index[axis + 1:]
        line, n = [a[at(k)] for k in range(degrees[axis] + 1)], degrees[axis]
        for k in range(n + 1):
            left[at(k)], right[at(n - k)] = line[0], line[-1]
            line = [(x + y) / 2 for x, y in zip(line, line[1:])]
    return left, right

# ---- Schemes and files -------------------------------------------------------------------------------------------------
def catalogue(text):  # the symbol of a named scheme
    family, _, rest = text.partition(':')
    args = {k: Checker().value(v) for k, _, v in (p.partition('=') for p in rest.split(',') if p)}
    n = lambda p, q=1: const(Q(p, q))
    row = lambda first, items: sum((f * power(var('z'), first + i) for i, f in enumerate(items)), n(0))
    if family == 'jspline':
        need(set(args) in ({'s'}, {'a', 'b'}), 'a J-spline has s, or a and b')
        a, b = args.get('a', args.get('s')), args.get('b', args.get('s'))
        o, e = (b - n(1)) * n(1, 16), a * n(1, 8)
        return row(-3, [o, e, n(1, 2) - o, n(1) - e - e, n(1, 2) - o, e, o])
    need(len(args) <= 1 and len(args) == rest.count('='), 'too many parameters')
    if family == 'four-point':
        need(set(args) <= {'w'}, 'w is needed')
        w = args.get('w', n(1, 16))
        return row(-3, [-w, n(0), n(1, 2) + w, n(1), n(1, 2) + w, n(0), -w])
    if family == 'dyn-floater-hormann':
        need(set(args) <= {'w'}, 'w is needed')
        w = args.get('w', n(1, 128))
        half = [n(-5) * w, n(-7) * w, n(1, 4) + n(3) * w, n(3, 4) + n(9) * w]
        return row(-4, half + half[::-1])
    if family == 'bspline':
        d = whole(args['degree'])
        return row(-((d + 1) // 2), [n(math.comb(d + 1, i), 2 ** d) for i in range(d + 2)])
    if family == 'deslauriers-dubuc':
        k = whole(args['points'] / n(2))
        w = lambda j: math.prod(Q(1 - 2 * i, 2 * (j - i)) for i in range(1 - k, k + 1) if i != j)
        return n(1) + sum((n(w(j)) * power(var('z'), 1 - 2 * j) for j in range(1 - k, k + 1)), n(0))
    raise Rejected('unknown scheme ' + text)
def check(text):
    lines = text.split('\n')
    need(text.endswith('\nend\n') and lines[0] == 'subdivlab certificate 1' and 'statement' in lines and 'proof' in lines, 'no whole certificate')
    s, p = lines.index('statement'), lines.index('proof')
    need(3 <= s < p - 1 and lines[1].startswith('claim '), 'no whole certificate')
    digest = hashlib.sha256('\n'.join([lines[1]] + lines[3:p] + ['']).encode()).hexdigest()
    need(lines[2] == 'digest ' + digest, 'the digest is that of another scheme or statement')
    need(any(line.split(' ', 1)[0] not in ('#', 'let', 'def', 'for') for line in lines[s + 1:p]), 'nothing is stated')
    c = Checker()
    c.proof = lines[p + 1:-2]
    for i, line in enumerate(lines[3:p], 3):
        try:
            if i >= s: c.state(line) if i > s else None
            elif line.startswith('scheme '):
                name, scheme, mask = re.fullmatch(r'scheme (\w+) (\S+) = (.*)', line).groups()
                need(c.is_free(name), 'named twice')
                c.names[name] = Checker().value(mask)
                need(c.equal(catalogue(scheme), c.names[name]), 'this is not the mask of ' + scheme)
            else:
                name, file, digest = re.fullmatch(r'data (\w+) (\S+) (\w+)', line).groups()
                need(c.is_free(name), 'named twice')
                c.names[name] = read_data(file)
                with open(os.path.join(DATA, file), 'rb') as f: need(hashlib.sha256(f.read()).hexdigest() == digest, 'other data')
        except Rejected as e: raise Rejected(f'{e} ({line})')
        except (ValueError, AttributeError, IndexError, KeyError, ZeroDivisionError, TypeError, RecursionError, OSError) as e:
            raise Rejected(f'malformed: {line}: {e!r}')
    need(not c.proof, 'the proof says more than is stated')
    return lines[1][6:], c.values

if __name__ == '__main__':
    status = 0
    for path in sys.argv[1:]:
        with open(path, encoding='utf-8', newline='') as file: content = file.read()
        try: print(f'{check(content)[0]}: proved')
        except Rejected as why: status, _ = 1, print(f'{path}: rejected: {why}')
    sys.exit(status)
