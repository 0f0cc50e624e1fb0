# Completion of subdivlab for fish, made by 'subdivlab completion fish'. Load it by
#   subdivlab completion fish | source

function __subdivlab_schemes
    # Behind the + of a mixed scheme another one begins.
    set -l before (commandline -ct | string match -r '.*\+')
    contains curve $argv; and printf "$before%s\n" jspline:s= jspline:a= bspline:degree= lane-riesenfeld:degree= four-point four-point:w= dyn-floater-hormann dyn-floater-hormann:w= deslauriers-dubuc deslauriers-dubuc:points=
    contains mesh $argv; and printf "$before%s\n" catmull-clark kobbelt jspline-mesh:s= jspline-mesh-literal:s= loop loop-1987 butterfly adjustable-speed:sigma=
    __fish_complete_suffix .json
end

function __subdivlab_claims
    set -l program (commandline -opc)[1]
    $program list claims 2>/dev/null | string match -r '^  \S+' | string trim
end

complete -c subdivlab -f
complete -c subdivlab -n __fish_use_subcommand -l version -d 'Display program version information and exit'
complete -c subdivlab -n __fish_use_subcommand -s h -l help -d 'Print this help message and exit'
complete -c subdivlab -n __fish_use_subcommand -a reproduce -d 'Run experiments, write the results folder, print the claims'
complete -c subdivlab -n __fish_use_subcommand -a check -d 'Run experiments again and compare with a results folder'
complete -c subdivlab -n __fish_use_subcommand -a analyze -d 'Say everything that can be said of a scheme'
complete -c subdivlab -n __fish_use_subcommand -a optimize -d 'Minimise an objective over free parameters, with proof'
complete -c subdivlab -n __fish_use_subcommand -a certify -d 'Prove smoothness for whole ranges of parameters'
complete -c subdivlab -n __fish_use_subcommand -a plot -d 'Draw a basis function, or smoothness over a parameter'
complete -c subdivlab -n __fish_use_subcommand -a eigen -d 'Eigenvalues and characteristic maps at extraordinary vertices of meshes'
complete -c subdivlab -n __fish_use_subcommand -a refine -d 'Refine a polygon, a grid or a mesh'
complete -c subdivlab -n __fish_use_subcommand -a rings -d 'Surface rings of adjustable speed around extraordinary vertices of a mesh of quads'
complete -c subdivlab -n __fish_use_subcommand -a bezier -d 'Draw Bezier curves as a polyline, with a proven distance'
complete -c subdivlab -n __fish_use_subcommand -a measure -d 'Measure polygons and their refinements'
complete -c subdivlab -n __fish_use_subcommand -a smooth -d 'Smooth a polygon by a sequence of operators'
complete -c subdivlab -n __fish_use_subcommand -a prove -d 'Find the certificates of statements'
complete -c subdivlab -n __fish_use_subcommand -a verify -d 'Check certificates in exact arithmetic, without searching'
complete -c subdivlab -n __fish_use_subcommand -a list -d 'Name the schemes, the claims, the objectives, the definitions'
complete -c subdivlab -n __fish_use_subcommand -a completion -d 'Print a script that teaches a shell verbs, options and values'
complete -c subdivlab -n __fish_use_subcommand -a manual -d 'Print the manual page'

complete -c subdivlab -n '__fish_seen_subcommand_from reproduce' -l help -s h -d 'Print this help message and exit'
complete -c subdivlab -n '__fish_seen_subcommand_from reproduce' -l claims -r -F -d 'Claims of your own, a JSON file, instead of those of the papers; --out is required then'
complete -c subdivlab -n '__fish_seen_subcommand_from reproduce' -l out -s o -r -a '(__fish_complete_directories)' -d 'The results folder to write (default: results)'
complete -c subdivlab -n '__fish_seen_subcommand_from reproduce' -l jobs -s j -r -d 'Experiments that run at the same time (default: one a processor)'
complete -c subdivlab -n '__fish_seen_subcommand_from reproduce' -a '(__subdivlab_claims)'

complete -c subdivlab -n '__fish_seen_subcommand_from check' -l help -s h -d 'Print this help message and exit'
complete -c subdivlab -n '__fish_seen_subcommand_from check' -l claims -r -F -d 'Claims of your own, a JSON file, instead of those of the papers; --against is required then'
complete -c subdivlab -n '__fish_seen_subcommand_from check' -l against -r -a '(__fish_complete_directories)' -d 'The results folder to compare with (default: results)'
complete -c subdivlab -n '__fish_seen_subcommand_from check' -l jobs -s j -r -d 'Experiments that run at the same time (default: one a processor)'
complete -c subdivlab -n '__fish_seen_subcommand_from check' -a '(__subdivlab_claims)'

complete -c subdivlab -n '__fish_seen_subcommand_from analyze' -l help -s h -d 'Print this help message and exit'
complete -c subdivlab -n '__fish_seen_subcommand_from analyze' -l budget -r -d 'Time for a joint spectral radius; then the enclosure reached is the answer'
complete -c subdivlab -n '__fish_seen_subcommand_from analyze' -l rounded -d 'Take each decimal in a scheme file as rounded: an interval of half a unit of its last digit'
complete -c subdivlab -n '__fish_seen_subcommand_from analyze' -l json -d 'Machine-readable output; numbers are strings'
complete -c subdivlab -n '__fish_seen_subcommand_from analyze' -a '(__subdivlab_schemes curve)'

complete -c subdivlab -n '__fish_seen_subcommand_from optimize' -l help -s h -d 'Print this help message and exit'
complete -c subdivlab -n '__fish_seen_subcommand_from optimize' -l over -r -d 'A range for each free parameter'
complete -c subdivlab -n '__fish_seen_subcommand_from optimize' -l objective -r -a 'area difference-norm difference-norm:continuity= edge edge-distance fit-bspline fit-bspline:continuum fit-bspline:degree= fit-bspline:level= polygon-distance popping popping:level= vertex vertex-distance' -d 'What to minimise: see \'subdivlab list objectives\''
complete -c subdivlab -n '__fish_seen_subcommand_from optimize' -l norm -r -a 'l1 l2 linf' -d 'The norm of the residuals: l1, l2 or linf; on a polygon linf when not given'
complete -c subdivlab -n '__fish_seen_subcommand_from optimize' -l polygon -r -F -d 'A closed polygon, .csv (x,y[,z] a line) or .obj, for objectives of its curve'
complete -c subdivlab -n '__fish_seen_subcommand_from optimize' -l json -d 'Machine-readable output; numbers are strings'
complete -c subdivlab -n '__fish_seen_subcommand_from optimize' -a '(__subdivlab_schemes curve)'

complete -c subdivlab -n '__fish_seen_subcommand_from certify' -l help -s h -d 'Print this help message and exit'
complete -c subdivlab -n '__fish_seen_subcommand_from certify' -l over -r -d 'A range for each free parameter'
complete -c subdivlab -n '__fish_seen_subcommand_from certify' -l continuity -r -d 'C^M: the differences of order M + 1 decide'
complete -c subdivlab -n '__fish_seen_subcommand_from certify' -l budget -r -d 'Time; what is left then is undecided'
complete -c subdivlab -n '__fish_seen_subcommand_from certify' -l json -d 'Machine-readable output; numbers are strings'
complete -c subdivlab -n '__fish_seen_subcommand_from certify' -a '(__subdivlab_schemes curve)'

complete -c subdivlab -n '__fish_seen_subcommand_from plot' -l help -s h -d 'Print this help message and exit'
complete -c subdivlab -n '__fish_seen_subcommand_from plot' -l over -r -d 'Draw the Hoelder exponent and the certified ranges over the free parameter'
complete -c subdivlab -n '__fish_seen_subcommand_from plot' -l out -s o -r -F -d 'A .svg file; - for standard output'
complete -c subdivlab -n '__fish_seen_subcommand_from plot' -a '(__subdivlab_schemes curve)'

complete -c subdivlab -n '__fish_seen_subcommand_from eigen' -l help -s h -d 'Print this help message and exit'
complete -c subdivlab -n '__fish_seen_subcommand_from eigen' -l valence -r -d 'The valences, one answer each'
complete -c subdivlab -n '__fish_seen_subcommand_from eigen' -l over -r -d 'A range for the free parameter: where the condition holds'
complete -c subdivlab -n '__fish_seen_subcommand_from eigen' -l json -d 'Machine-readable output; numbers are strings'
complete -c subdivlab -n '__fish_seen_subcommand_from eigen' -a '(__subdivlab_schemes mesh)'

complete -c subdivlab -n '__fish_seen_subcommand_from refine' -l help -s h -d 'Print this help message and exit'
complete -c subdivlab -n '__fish_seen_subcommand_from refine' -l scheme -r -a '(__subdivlab_schemes curve mesh)' -d 'The scheme, instead of SCHEME'
complete -c subdivlab -n '__fish_seen_subcommand_from refine' -l levels -s k -r -d 'How often: K steps of the scheme'
complete -c subdivlab -n '__fish_seen_subcommand_from refine' -l out -s o -r -F -d 'A .csv, .obj or .svg file, of a mesh .obj, .off, .ply or .svg; - for standard output'
complete -c subdivlab -n '__fish_seen_subcommand_from refine' -l open -r -a 'clamped reflected' -d 'An open curve, or open rows of a grid: clamped or reflected ends'
complete -c subdivlab -n '__fish_seen_subcommand_from refine' -l grid -r -d 'The points are a grid, a row after the other'
complete -c subdivlab -n '__fish_seen_subcommand_from refine' -l open-across -r -a 'clamped reflected' -d 'Open columns of a grid'
complete -c subdivlab -n '__fish_seen_subcommand_from refine' -l details -r -F -d 'Points moved at their levels: .csv lines level,index,dx,dy[,dz]'
complete -c subdivlab -n '__fish_seen_subcommand_from refine' -l retrofit -r -a 'direct iteration' -d 'Make the limit pass through the points: direct, or by the papers\' iteration'
complete -c subdivlab -n '__fish_seen_subcommand_from refine' -l limit -d 'Write the limit points of the last level, of a mesh with normals'
complete -c subdivlab -n '__fish_seen_subcommand_from refine' -l threads -r -d 'Threads for a mesh (default: one a processor)'
complete -c subdivlab -n '__fish_seen_subcommand_from refine' -a '(__subdivlab_schemes curve mesh)'
complete -c subdivlab -n '__fish_seen_subcommand_from refine' -F

complete -c subdivlab -n '__fish_seen_subcommand_from rings' -l help -s h -d 'Print this help message and exit'
complete -c subdivlab -n '__fish_seen_subcommand_from rings' -l sigma -r -d 'Speeds between 0 and 1, one a step; 1/2 is Catmull-Clark\'s (default: no steps)'
complete -c subdivlab -n '__fish_seen_subcommand_from rings' -l out -s o -r -F -d 'The surface, each patch as quads: .obj in groups, .off, .ply or .svg; - for standard output'
complete -c subdivlab -n '__fish_seen_subcommand_from rings' -l control-points -r -F -d 'The patches: .obj with free-form surfaces, or .bv for BezierView'
complete -c subdivlab -n '__fish_seen_subcommand_from rings' -l catmull-clark-step -d 'Refine the mesh once first (twice when given twice): quads, and extraordinary vertices apart from each other and from borders'
complete -c subdivlab -n '__fish_seen_subcommand_from rings' -l fill -d 'Fill what the last ring leaves open with bicubic caps'
complete -c subdivlab -n '__fish_seen_subcommand_from rings' -l tessellation -r -d 'N x N quads for each patch'
complete -c subdivlab -n '__fish_seen_subcommand_from rings' -l rings-only -d 'Leave out the patches of regular faces'
complete -c subdivlab -n '__fish_seen_subcommand_from rings' -l json -d 'Machine-readable report of patches and holes; numbers are strings'
complete -c subdivlab -n '__fish_seen_subcommand_from rings' -F

complete -c subdivlab -n '__fish_seen_subcommand_from bezier' -l help -s h -d 'Print this help message and exit'
complete -c subdivlab -n '__fish_seen_subcommand_from bezier' -l degree -r -d 'The degree of every curve'
complete -c subdivlab -n '__fish_seen_subcommand_from bezier' -l tolerance -r -d 'Halve each part until its chord is proved to be this near to the curve'
complete -c subdivlab -n '__fish_seen_subcommand_from bezier' -l depth -s k -r -d 'Halve K times and draw the control polygons, whatever the distance'
complete -c subdivlab -n '__fish_seen_subcommand_from bezier' -l out -s o -r -F -d 'The polyline: .csv, .obj, .svg, or - for standard output'
complete -c subdivlab -n '__fish_seen_subcommand_from bezier' -l json -d 'Machine-readable report of segments and the distance; numbers are strings'
complete -c subdivlab -n '__fish_seen_subcommand_from bezier' -F

complete -c subdivlab -n '__fish_seen_subcommand_from measure' -l help -s h -d 'Print this help message and exit'
complete -c subdivlab -n '__fish_seen_subcommand_from measure' -l open -r -a 'plain clamped reflected' -d 'An open polygon: plain, or with the ends of a scheme, clamped or reflected'
complete -c subdivlab -n '__fish_seen_subcommand_from measure' -l scheme -r -a '(__subdivlab_schemes curve)' -d 'Measure its refinements, too'
complete -c subdivlab -n '__fish_seen_subcommand_from measure' -l levels -s k -r -d 'How often to refine'
complete -c subdivlab -n '__fish_seen_subcommand_from measure' -l against -r -F -d 'Another polygon: the Hausdorff distance between them'
complete -c subdivlab -n '__fish_seen_subcommand_from measure' -l tolerance -r -d 'Width of the bounds of distances (default: a millionth of the extent)'
complete -c subdivlab -n '__fish_seen_subcommand_from measure' -l local -d 'Velocity, acceleration, curvature radii and jerk at every vertex, of the finest level'
complete -c subdivlab -n '__fish_seen_subcommand_from measure' -l json -d 'Machine-readable output; numbers are strings'
complete -c subdivlab -n '__fish_seen_subcommand_from measure' -F

complete -c subdivlab -n '__fish_seen_subcommand_from smooth' -l help -s h -d 'Print this help message and exit'
complete -c subdivlab -n '__fish_seen_subcommand_from smooth' -l operators -r -d 'refine, split, dual, tuck(t), untuck, tweak(old, new), J(s), separated by ;, {..}^N to repeat'
complete -c subdivlab -n '__fish_seen_subcommand_from smooth' -l repeat -r -d 'How often to apply the sequence'
complete -c subdivlab -n '__fish_seen_subcommand_from smooth' -l open -r -a 'drop keep' -d 'An open polygon: vertices whose rules reach beyond its ends are dropped, or keep their places'
complete -c subdivlab -n '__fish_seen_subcommand_from smooth' -l json -r -F -d 'Write a machine-readable report; numbers are strings'
complete -c subdivlab -n '__fish_seen_subcommand_from smooth' -l out -s o -r -F -d 'A .csv, .obj or .svg file; - for standard output'
complete -c subdivlab -n '__fish_seen_subcommand_from smooth' -F

complete -c subdivlab -n '__fish_seen_subcommand_from prove' -l help -s h -d 'Print this help message and exit'
complete -c subdivlab -n '__fish_seen_subcommand_from prove' -l out -s o -r -a '(__fish_complete_directories)' -d 'The folder to write to, ID.txt for each claim'
complete -c subdivlab -n '__fish_seen_subcommand_from prove' -l claims -r -a '(__fish_complete_directories)' -d 'The results folder with the values that $exact, $lower and $upper stand for'
complete -c subdivlab -n '__fish_seen_subcommand_from prove' -F

complete -c subdivlab -n '__fish_seen_subcommand_from verify' -l help -s h -d 'Print this help message and exit'
complete -c subdivlab -n '__fish_seen_subcommand_from verify' -l print-statement -d 'Say in words what each one proves'
complete -c subdivlab -n '__fish_seen_subcommand_from verify' -l missing -d 'List the exact or certified claims that have no certificate'
complete -c subdivlab -n '__fish_seen_subcommand_from verify' -F

complete -c subdivlab -n '__fish_seen_subcommand_from list' -l help -s h -d 'Print this help message and exit'
complete -c subdivlab -n '__fish_seen_subcommand_from list' -l json -d 'Machine-readable output'
complete -c subdivlab -n '__fish_seen_subcommand_from list' -a 'schemes claims objectives definitions'

complete -c subdivlab -n '__fish_seen_subcommand_from completion' -l help -s h -d 'Print this help message and exit'
complete -c subdivlab -n '__fish_seen_subcommand_from completion' -a 'bash zsh fish'

complete -c subdivlab -n '__fish_seen_subcommand_from manual' -l help -s h -d 'Print this help message and exit'
