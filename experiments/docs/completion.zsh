#compdef subdivlab
# Completion of subdivlab for zsh, made by 'subdivlab completion zsh': a file _subdivlab in a folder of $fpath, or
#   source <(subdivlab completion zsh)

_subdivlab_schemes() {
  local -a names
  local kind
  for kind in "$@"; do
    case $kind in
      curve) names+=(jspline:s= jspline:a= bspline:degree= lane-riesenfeld:degree= four-point four-point:w= dyn-floater-hormann dyn-floater-hormann:w= deslauriers-dubuc deslauriers-dubuc:points=) ;;
      mesh) names+=(catmull-clark kobbelt jspline-mesh:s= jspline-mesh-literal:s= loop loop-1987 butterfly adjustable-speed:sigma=) ;;
    esac
  done
  # Behind the + of a mixed scheme another one begins.
  [[ $PREFIX != *+* ]] || compset -P '*+'
  compadd -S '' -- $names
  _files -g '*.json'
}

_subdivlab_objectives() { compadd -S '' -- area difference-norm difference-norm:continuity= edge edge-distance fit-bspline fit-bspline:continuum fit-bspline:degree= fit-bspline:level= polygon-distance popping popping:level= vertex vertex-distance; }

_subdivlab_claims() {
  local -a lines
  lines=(${(M)${(f)"$($program list claims 2>/dev/null)"}:#  *})
  compadd -- ${${lines#  }%% *}
}

_subdivlab() {
  local program=$words[1] context state line
  typeset -A opt_args
  _arguments -C '(- *)'{-h,--help}'[Print this help message and exit]' \
    '(- *)--version[Display program version information and exit]' '1:verb:->verb' '*::argument:->argument'
  case $state in
    verb)
      local -a verbs
      verbs=(
        'reproduce:Run experiments, write the results folder, print the claims'
        'check:Run experiments again and compare with a results folder'
        'analyze:Say everything that can be said of a scheme'
        'optimize:Minimise an objective over free parameters, with proof'
        'certify:Prove smoothness for whole ranges of parameters'
        'plot:Draw a basis function, or smoothness over a parameter'
        'eigen:Eigenvalues and characteristic maps at extraordinary vertices of meshes'
        'refine:Refine a polygon, a grid or a mesh'
        'rings:Surface rings of adjustable speed around extraordinary vertices of a mesh of quads'
        'bezier:Draw Bezier curves as a polyline, with a proven distance'
        'measure:Measure polygons and their refinements'
        'smooth:Smooth a polygon by a sequence of operators'
        'prove:Find the certificates of statements'
        'verify:Check certificates in exact arithmetic, without searching'
        'list:Name the schemes, the claims, the objectives, the definitions'
        'completion:Print a script that teaches a shell verbs, options and values'
        'manual:Print the manual page'
      )
      _describe verb verbs
      ;;
    argument)
      case $line[1] in
        reproduce)
          _arguments \
            '(--help -h)'{--help,-h}'[Print this help message and exit]' \
            '--claims[Claims of your own, a JSON file, instead of those of the papers; --out is required then]:FILE.json:_files' \
            '(--out -o)'{--out,-o}'[The results folder to write (default\: results)]:DIR:_files -/' \
            '(--jobs -j)'{--jobs,-j}'[Experiments that run at the same time (default\: one a processor)]:N: ' \
            '*:PATTERN:_subdivlab_claims'
          ;;
        check)
          _arguments \
            '(--help -h)'{--help,-h}'[Print this help message and exit]' \
            '--claims[Claims of your own, a JSON file, instead of those of the papers; --against is required then]:FILE.json:_files' \
            '--against[The results folder to compare with (default\: results)]:DIR:_files -/' \
            '(--jobs -j)'{--jobs,-j}'[Experiments that run at the same time (default\: one a processor)]:N: ' \
            '*:PATTERN:_subdivlab_claims'
          ;;
        analyze)
          _arguments \
            '(--help -h)'{--help,-h}'[Print this help message and exit]' \
            '--budget[Time for a joint spectral radius; then the enclosure reached is the answer]:SECONDS: ' \
            '--rounded[Take each decimal in a scheme file as rounded\: an interval of half a unit of its last digit]' \
            '--json[Machine-readable output; numbers are strings]' \
            ':SCHEME:_subdivlab_schemes curve'
          ;;
        optimize)
          _arguments \
            '(--help -h)'{--help,-h}'[Print this help message and exit]' \
            '--over[A range for each free parameter]:s=LO..HI\[,...\]: ' \
            '--objective[What to minimise\: see '\''subdivlab list objectives'\'']:NAME\[\:option=value,...\]:_subdivlab_objectives' \
            '--norm[The norm of the residuals\: l1, l2 or linf; on a polygon linf when not given]:NORM:(l1 l2 linf)' \
            '--polygon[A closed polygon, .csv (x,y\[,z\] a line) or .obj, for objectives of its curve]:FILE:_files' \
            '--json[Machine-readable output; numbers are strings]' \
            ':SCHEME:_subdivlab_schemes curve'
          ;;
        certify)
          _arguments \
            '(--help -h)'{--help,-h}'[Print this help message and exit]' \
            '--over[A range for each free parameter]:s=LO..HI\[,...\]: ' \
            '--continuity[C^M\: the differences of order M + 1 decide]:M: ' \
            '--budget[Time; what is left then is undecided]:SECONDS: ' \
            '--json[Machine-readable output; numbers are strings]' \
            ':SCHEME:_subdivlab_schemes curve'
          ;;
        plot)
          _arguments \
            '(--help -h)'{--help,-h}'[Print this help message and exit]' \
            '--over[Draw the Hoelder exponent and the certified ranges over the free parameter]:s=LO..HI: ' \
            '(--out -o)'{--out,-o}'[A .svg file; - for standard output]:FIGURE.svg:_files' \
            ':SCHEME:_subdivlab_schemes curve'
          ;;
        eigen)
          _arguments \
            '(--help -h)'{--help,-h}'[Print this help message and exit]' \
            '--valence[The valences, one answer each]:N|LO..HI: ' \
            '--over[A range for the free parameter\: where the condition holds]:s=LO..HI: ' \
            '--json[Machine-readable output; numbers are strings]' \
            ':SCHEME:_subdivlab_schemes mesh'
          ;;
        refine)
          _arguments \
            '(--help -h)'{--help,-h}'[Print this help message and exit]' \
            '--scheme[The scheme, instead of SCHEME]:SCHEME:_subdivlab_schemes curve mesh' \
            '(--levels -k)'{--levels,-k}'[How often\: K steps of the scheme]:K: ' \
            '(--out -o)'{--out,-o}'[A .csv, .obj or .svg file, of a mesh .obj, .off, .ply or .svg; - for standard output]:OUTPUT:_files' \
            '--open[An open curve, or open rows of a grid\: clamped or reflected ends]:ENDS:(clamped reflected)' \
            '--grid[The points are a grid, a row after the other]:ROWSxCOLUMNS: ' \
            '--open-across[Open columns of a grid]:ENDS:(clamped reflected)' \
            '--details[Points moved at their levels\: .csv lines level,index,dx,dy\[,dz\]]:FILE:_files' \
            '--retrofit[Make the limit pass through the points\: direct, or by the papers'\'' iteration]:HOW:(direct iteration)' \
            '--limit[Write the limit points of the last level, of a mesh with normals]' \
            '--threads[Threads for a mesh (default\: one a processor)]:N: ' \
            ':SCHEME:_subdivlab_schemes curve mesh' \
            ':INPUT:_files'
          ;;
        rings)
          _arguments \
            '(--help -h)'{--help,-h}'[Print this help message and exit]' \
            '--sigma[Speeds between 0 and 1, one a step; 1/2 is Catmull-Clark'\''s (default\: no steps)]:S\[,S...\]: ' \
            '(--out -o)'{--out,-o}'[The surface, each patch as quads\: .obj in groups, .off, .ply or .svg; - for standard output]:OUTPUT:_files' \
            '--control-points[The patches\: .obj with free-form surfaces, or .bv for BezierView]:FILE:_files' \
            '--catmull-clark-step[Refine the mesh once first (twice when given twice)\: quads, and extraordinary vertices apart from each other and from borders]' \
            '--fill[Fill what the last ring leaves open with bicubic caps]' \
            '--tessellation[N x N quads for each patch]:N: ' \
            '--rings-only[Leave out the patches of regular faces]' \
            '--json[Machine-readable report of patches and holes; numbers are strings]' \
            ':INPUT:_files'
          ;;
        bezier)
          _arguments \
            '(--help -h)'{--help,-h}'[Print this help message and exit]' \
            '--degree[The degree of every curve]:N: ' \
            '--tolerance[Halve each part until its chord is proved to be this near to the curve]:T: ' \
            '(--depth -k)'{--depth,-k}'[Halve K times and draw the control polygons, whatever the distance]:K: ' \
            '(--out -o)'{--out,-o}'[The polyline\: .csv, .obj, .svg, or - for standard output]:OUTPUT:_files' \
            '--json[Machine-readable report of segments and the distance; numbers are strings]' \
            ':INPUT:_files'
          ;;
        measure)
          _arguments \
            '(--help -h)'{--help,-h}'[Print this help message and exit]' \
            '--open[An open polygon\: plain, or with the ends of a scheme, clamped or reflected]:ENDS:(plain clamped reflected)' \
            '--scheme[Measure its refinements, too]:SCHEME:_subdivlab_schemes curve' \
            '(--levels -k)'{--levels,-k}'[How often to refine]:K: ' \
            '--against[Another polygon\: the Hausdorff distance between them]:FILE:_files' \
            '--tolerance[Width of the bounds of distances (default\: a millionth of the extent)]:T: ' \
            '--local[Velocity, acceleration, curvature radii and jerk at every vertex, of the finest level]' \
            '--json[Machine-readable output; numbers are strings]' \
            ':INPUT:_files'
          ;;
        smooth)
          _arguments \
            '(--help -h)'{--help,-h}'[Print this help message and exit]' \
            '--operators[refine, split, dual, tuck(t), untuck, tweak(old, new), J(s), separated by ;, {..}^N to repeat]:SEQUENCE: ' \
            '--repeat[How often to apply the sequence]:N: ' \
            '--open[An open polygon\: vertices whose rules reach beyond its ends are dropped, or keep their places]:ENDS:(drop keep)' \
            '--json[Write a machine-readable report; numbers are strings]:REPORT:_files' \
            '(--out -o)'{--out,-o}'[A .csv, .obj or .svg file; - for standard output]:OUTPUT:_files' \
            ':INPUT:_files'
          ;;
        prove)
          _arguments \
            '(--help -h)'{--help,-h}'[Print this help message and exit]' \
            '(--out -o)'{--out,-o}'[The folder to write to, ID.txt for each claim]:DIR:_files -/' \
            '--claims[The results folder with the values that $exact, $lower and $upper stand for]:DIR:_files -/' \
            '*:FILE:_files'
          ;;
        verify)
          _arguments \
            '(--help -h)'{--help,-h}'[Print this help message and exit]' \
            '--print-statement[Say in words what each one proves]' \
            '--missing[List the exact or certified claims that have no certificate]' \
            '*:PATH:_files'
          ;;
        list)
          _arguments \
            '(--help -h)'{--help,-h}'[Print this help message and exit]' \
            '--json[Machine-readable output]' \
            ':WHAT:(schemes claims objectives definitions)'
          ;;
        completion)
          _arguments \
            '(--help -h)'{--help,-h}'[Print this help message and exit]' \
            ':SHELL:(bash zsh fish)'
          ;;
        manual)
          _arguments \
            '(--help -h)'{--help,-h}'[Print this help message and exit]'
          ;;
      esac
      ;;
  esac
}

if [[ $funcstack[1] == _subdivlab ]]; then _subdivlab "$@"; else compdef _subdivlab subdivlab; fi
