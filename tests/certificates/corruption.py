#!/usr/bin/env python3
"""Corrupted certificates: corruption.py PROGRAM FOLDER.

Of certificates in FOLDER that use every kind of witness, each number is changed, each line deleted, doubled and swapped
with the next one, the file cut off, and its scheme replaced; once as it is, and once with the digest made anew, so that
the checkers have to look at the mathematics. `PROGRAM verify` and check.py must give the same verdict on every one of
them; without a new digest a changed head or statement must be rejected. Traps are false statements with proofs that
look right: both must reject them."""
import hashlib, os, re, subprocess, sys, tempfile
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import check as second

def with_digest(text):
    lines = text.split('\n')
    end = lines.index('proof') if 'proof' in lines else len(lines)
    digest = hashlib.sha256('\n'.join([lines[1]] + lines[3:end] + ['']).encode()).hexdigest()
    return '\n'.join([*lines[:2], 'digest ' + digest, *lines[3:]])

def verdict(text):
    try: second.check(text)
    except second.Rejected: return 'rejected'
    return 'proved'

def made(statement, proof, head=()):
    return with_digest('\n'.join(['subdivlab certificate 1', 'claim trap', 'digest -', *head, 'statement', *statement, 'proof', *proof, 'end', '']))

TRAPS = [
    (['1 > 2'], []), (['1 > 1'], []), (['1/2+1/3 == 1'], []), (['x == y'], []),
    (['for s in [0,1]', 's > 0'], ['cover .']),                        # 0 at the closed end
    (['for s in (0,1)', 's*(1-s) > s*(1-s)'], ['cover .']),            # 0 everywhere, open ends or not
    (['for s in (0,1)', 'rows [s] < s'], ['cover .']),                 # equality on the whole interval
    (['for s in (0,1)', '(s-1/2)^2 > 0'], ['cover s . .']),            # 0 inside, at the common end of two cells
    (['for s in (0,1)', '(s-1/2)^2 != 0'], ['cover s . .']),
    (['for s in (0,2)', '1-s > 0'], ['cover .']),
    (['for s in [-1,1]', '1/s^2 > 1/2'], ['cover .']),                 # a denominator that vanishes
    (['for s in [-1,1]', '1/s >= -2'], ['cover .']),
    (['for s in [0,inf)', '10-s > 0'], ['cover .']), (['s > 0'], ['cover .']),
    (['for s in [0,1]', 'for t in [0,1]', 's+t > 0'], ['cover .']), (['for s in (0,1]', 'for t in (0,1]', 's-t > 0'], ['cover .']),
    (['for s in (0,1)', 'for t in [0,1]', 's*t > 0'], ['cover .']),    # 0 on a face that belongs to the box
    (['for s in [0,1]', 's > -1'], ['cover . .']), (['for s in [0,1]', 's > -1'], ['cover s .']), (['for s in [0,1]', 's > -1'], ['cover']),
    (['root r of r^2-2 in [2,3]'], ['cover .']), (['root r of r^3-r in [-2,2]'], ['cover .']), (['root r of (r-1)^2 in [0,3]'], ['cover .']),
    (['root r of r^2-2 in [1,2]', 'r == 1.4142135'], ['cover .']), (['root r of r^2-2 in [1,2]', '1/(r^2-2) == 1/(r^2-2)'], ['cover .']),
    (['root r of r^2-2 in [-3/2,-1]', 'r > 0'], ['cover .', 'cover .']),
    (['peak [1/2,1/3] > 1/2'], ['cover +0']), (['for s in [0,1]', 'peak [s,1-s] > 1/2'], ['cover s +1 +0']),
    (['for s in [0,1]', 'peak [s,1-s] > 1/4'], ['cover s +1 +2']), (['for s in [0,1]', 'peak [s,1-s] > 1/4'], ['cover s -1 +0']),
    (['radius [[[2]]] <= 1'], ['vertices [[1]]', 'images [[1]]', 'span [0]']),
    (['radius [[[2,0],[0,1/2]]] <= 1'], ['vertices [[0,1]]', 'images [[1/2]]', 'span [0]']),
    (['radius [[[2,0],[0,1/2]]] <= 1'], ['vertices [[0,1],[0,2]]', 'images [[1/2,0],[1,0]]', 'span [0,1]']),
    (['radius [[[2,0],[0,1/2]]] <= 1'], ['vertices [[0,1]]', 'images [[1/2]]', 'span [0,0]']),
    (['radius [[[1/2]],[[2]]] <= 1'], ['vertices [[1]]', 'images [[1/2]]', 'span [0]']),
    (['radius [[[0,1],[0,0]]] >= 1'], ['word [0]', 'space [[1],[0]]', 'block [[1]]']),
    (['radius [[[0,1],[0,0]]] >= 1'], ['word [0]', 'space [[0],[0]]', 'block [[1]]']),
    (['radius [[[2]]] >= 3'], ['word [0]', 'space [[1]]', 'block [[3]]']), (['radius [[[2]]] >= 3'], ['word [0,0]', 'space [[1]]', 'block [[4]]']),
    (['radius [[[2]]] >= 2'], ['word []', 'space [[1]]', 'block [[2]]']),
    (['least max [x-1,x+1] over x == 1/2 at 0'], ['dual [-1/2,1/2]']), (['least max [x-1,x+1] over x == 1 at 1/2'], ['dual [-1/2,1/2]']),
    (['least max [x-1,x+1] over x == 2 at 0'], ['dual [-1,1]']), (['least sum [x,x-1] over x == 2 at 0'], ['dual [2,-2]']),
    (['least sum [x,x-1] over x == 1 at 2'], ['dual [1,-1]']), (['least max [x,1] over x == 1 at 0'], ['dual [1/2,1/2]']),
    (['for s in [0,3]', 'minimum max [s-1,s-2] over s == 1/2 at 1'], ['near [5/4,7/4]', 'active -1 +0', 'cover -1', 'cover +0']),
    (['for s in [0,3]', 'minimum max [s-1,s-2] over s == 1/2 at 3/2'], ['near [5/4,7/4]', 'active +0 +0', 'cover -1', 'cover +0']),
    (['for s in [0,3]', 'minimum max [s-1,s-2] over s == 1/2 at 3/2'], ['near [2,3]', 'active -1 +0', 'cover -1', 'cover +0']),
    (['for s in [0,3]', 'minimum max [s-1,s-2] over s == 1 at 3/2'], ['near [5/4,7/4]', 'active -1 +0', 'cover -1', 'cover +0']),
    # at lies outside the range, which `near` leaves
    (['for s in [0,1]', 'minimum max [s-1,s-2] over s == 1/2 at 3/2'], ['near [5/4,7/4]', 'active -1 +0', 'cover -1']),
    # names that mean two things
    (['let s = 1', 'for s in [0,1]', 's > 1/2'], []), (['for s in [0,1]', 'let s = 1', 's > 1/2'], []),
    (['root r of r^2-2 in [5/4,2]', 'let r = 5', 'r > 4'], ['cover .']), (['let x = 5', 'least max [x-1] over x == 4 at 0'], ['dual [1]']),
    (['def abs(x) = 1', 'abs(2) == 1'], []), (['def f(x) = 1', 'def f(x) = 2', 'f(0) == 2'], []), (['let y = 2*x', 'diff(y, y) == 0'], []),
    (['for x in [1,2]', 'least max [x] over x == 0 at 0'], ['dual [0]']),
    (['root r of r^2-2 in [5/4,2]', 'least max [r^2-2] over r == 0 at 0'], ['cover .', 'dual [0]']),
    (['root r of r^2-2 in [5/4,2]', 'high((r^2-2)*z^5+z, z) == 5'], ['cover .']), (['root r of r^2-2 in [5/4,2]', 'subst(r^2-2, r, 1) == -1'], ['cover .']),
    (['let x = 1'], []), (['for s in [0,1]', '# s > 2'], []), (['for s in (1,1)', 's > 0'], ['cover .']), (['rows [] < 1'], []), (['rows [[]] < 1'], []),
    (['radius [3] >= 3'], ['word [0]', 'space [[1]]', 'block [[3]]']), (['radius [[[2]],[[1,0],[0,1]]] >= 2'], ['word [0]', 'space [[1]]', 'block [[2]]']),
    (['[1,1]*[[1,2],[3]] == [4]'], []), (['join(1,2) == 3'], []), (['[1,2]^0 == 1'], []), (['det([[1]], 2) == 1'], []), (['2**3 == 8'], []),
    (['1_0 == 10'], []), (['len([1,]) == 1'], []), (['1 == 1 # two'], []),
    (['1 == 1'], ['cover .']), (['nonsense'], []), (['let x = 1/0'], []), (['let x = [1,2][2]', '1 == 1'], []), (['det([[1,2]]) == 1'], []),
]
TRUE = [
    (['for s in (0,1)', 's^3*(1-s)^2 > 0'], ['cover .']), (['for s in [0,inf)', 's+1 > 0'], ['cover .']),
    (['for s in (0,1]', 'for t in (0,1]', 's*t > 0'], ['cover .']), (['lambda-lambda == 0'], []), (['007 == 7.0'], []),
    (['root r of r^2-2 in [5/4,2]', '1/r > 1/3'], ['cover .', 'cover .']), (['root r of r^2-2 in [5/4,2]', 'r^4 == 4', 'r > 1'], ['cover .', 'cover .']),
    (['radius [[[0,1],[1,0]]] >= 1'], ['word [0]', 'space [[1],[1]]', 'block [[1]]']),
    (['radius [[[0,-1],[1,0]]] >= 1'], ['word [0]', 'space [[1,0],[0,1]]', 'block [[0,-1],[1,0]]']),
    (['radius [[[1/2,1],[0,1/2]]] <= 3/4'], ['vertices [[4,0],[0,1]]', 'images [[1/2,0],[1/4,1/2]]', 'span [0,1]']),
    (['least max [x-1,x+1] over x == 1 at 0'], ['dual [-1/2,1/2]']), (['least sum [x,x-1] over x == 1 at 1/2'], ['dual [1,-1]']),
    (['for s in [0,3]', 'minimum max [s-1,s-2] over s == 1/2 at 3/2'], ['near [5/4,7/4]', 'active -1 +0', 'cover -1', 'cover +0']),
    (['for s in [0,1]', 'peak [s,1-s] > 1/4'], ['cover s -1 +0'.replace('-1', '+1')]),
]

def corrupted(text):
    """(what was done, text) for every corruption of a certificate; digests stay as they are."""
    for match in list(re.finditer(r'\d+', text)):
        if text.rfind('\n', 0, match.start()) < text.find('\ndigest ') + 1 <= match.start(): continue
        new = str(int(match[0]) + 1) if match.start() % 3 else '0' if int(match[0]) else '7'
        yield f'number at {match.start()}', text[:match.start()] + new + text[match.end():]
    lines = text.split('\n')
    for i in range(len(lines) - 1):
        yield f'line {i + 1} deleted', '\n'.join(lines[:i] + lines[i + 1:])
        yield f'line {i + 1} doubled', '\n'.join(lines[:i + 1] + lines[i:])
        yield f'lines {i + 1}, {i + 2} swapped', '\n'.join(lines[:i] + [lines[i + 1], lines[i]] + lines[i + 2:])
        yield f'cut off in line {i + 1}', '\n'.join(lines[:i] + [lines[i][:len(lines[i]) // 2]])
    for minus in [m.start() for m in re.finditer('-', text)]: yield f'sign at {minus}', text[:minus] + '+' + text[minus + 1:]
    yield 'another scheme', re.sub(r'^(scheme \w+) \S+', r'\1 four-point:w=1/17', text, flags=re.M)

def chosen(folder):
    """The two smallest certificates that use each kind of statement and witness."""
    found = {}
    for name in sorted(os.listdir(folder)):
        with open(os.path.join(folder, name), encoding='utf-8', newline='') as file: text = file.read()
        words = {line.split(' ', 1)[0] for line in text.split('\n')} & {'cover', 'vertices', 'word', 'dual', 'near', 'root', 'peak', 'rows', 'scheme', 'data'}
        for word in words: found.setdefault(word, []).append((len(text), name, text))
    names = {}
    for word in sorted(found):
        for _, name, text in sorted(found[word])[:1 if word == 'data' else 2]: names[name] = text
    return names

def main(program, folder):
    cases = []  # (name, text, verdict that is known or None)
    cases += [(f'trap {i}: {s[-1]}', made(s, p), 'rejected') for i, (s, p) in enumerate(TRAPS)]
    cases.append(('trap: a scheme that nobody knows', made(['S == 1'], [], ['scheme S unknown:s=1 = 1']), 'rejected'))
    cases += [(f'true {i}: {s[-1]}', made(s, p), 'proved') for i, (s, p) in enumerate(TRUE)]
    for name, text in chosen(folder).items():
        cases.append((name, text, 'proved'))
        head = text[:text.index('\nproof\n')]
        for what, bad in corrupted(text):
            if bad == text: continue
            touched = not bad.startswith(head + '\nproof\n')
            cases.append((f'{name}: {what}', bad, 'rejected' if touched else None))
            if touched and what.startswith(('number', 'sign', 'another')): cases.append((f'{name}: {what}, new digest', with_digest(bad), None))
    failures, kept = 0, 0
    with tempfile.TemporaryDirectory() as temporary:
        paths = []
        for i, (_, text, _) in enumerate(cases):
            paths.append(os.path.join(temporary, f'{i}.txt'))
            with open(paths[-1], 'w', encoding='utf-8', newline='') as file: file.write(text)
        accepted = set()
        for begin in range(0, len(paths), 500):
            run = subprocess.run([program, 'verify', *paths[begin:begin + 500]], capture_output=True, text=True)
            if run.returncode not in (0, 1): sys.exit(f'{program} verify ended with {run.returncode}: {run.stderr[-500:]}')
            accepted |= {line[:-len(': proved')] for line in run.stdout.split('\n') if line.endswith(': proved')}
    for (name, text, known), path in zip(cases, paths):
        first = 'proved' if path in accepted else 'rejected'
        other = verdict(text)
        kept += known is None and first == 'proved'
        if first == other and known in (None, first): continue
        failures += 1
        print(f'{name}: verify says {first}, check.py says {other}, expected {known or "the same"}')
    print(f'{len(cases)} certificates, {kept} of the corrupted ones still prove what they state, for both checkers')
    print(f'{len(cases) - failures} passed, {failures} failed')
    return failures > 0

if __name__ == '__main__': sys.exit(main(*sys.argv[1:]))
