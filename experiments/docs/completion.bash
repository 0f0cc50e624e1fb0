# Completion of subdivlab for bash, made by 'subdivlab completion bash'. Load it, for example in ~/.bashrc, by
#   source <(subdivlab completion bash)

# Where the word to complete stands: `place` is the option whose value it is, or the number of words before it.
_subdivlab_place() {
  local i
  place=0
  for ((i = 2; i < ${#words[@]} - 1; ++i)); do
    if [[ " $valued " == *" ${words[i]} "* ]]; then
      if ((i + 1 == ${#words[@]} - 1)); then
        place=${words[i]}
        return
      fi
      ((++i))
    elif [[ ${words[i]} != -?* ]]; then
      ((++place))
    fi
  done
  if [[ $word == --*=* && " $valued " == *" ${word%%=*} "* ]]; then
    place=${word%%=*}
    word=${word#*=}
  fi
}

# The candidates that go on from the word; without a space behind those that end in =.
_subdivlab_words() {
  local candidate
  for candidate in "$@"; do
    [[ $candidate != "$word"* ]] || COMPREPLY+=("$candidate")
  done
  if [[ ${#COMPREPLY[@]} -eq 1 && ${COMPREPLY[0]} == *= ]]; then compopt -o nospace 2>/dev/null; fi
}

# Beginnings of SCHEME, behind the last + of a mixed scheme, and scheme files.
_subdivlab_schemes() {
  local before='' candidate
  [[ $word != *+* ]] || before=${word%+*}+
  local -a candidates=()
  for candidate in "$@"; do candidates+=("$before$candidate"); done
  while IFS= read -r candidate; do
    [[ -d $candidate ]] && candidates+=("$candidate/")
    [[ $candidate == *.json ]] && candidates+=("$candidate")
  done < <(compgen -f -- "$word")
  _subdivlab_words "${candidates[@]}"
  if [[ ${#COMPREPLY[@]} -eq 1 && ${COMPREPLY[0]} == */ ]]; then compopt -o nospace 2>/dev/null; fi
}

_subdivlab_claims() {
  local line
  while IFS= read -r line; do
    [[ $line != '  '* ]] || echo "${line:2}"
  done < <("${words[0]}" list claims 2>/dev/null) | while read -r line _; do echo "$line"; done
}

_subdivlab() {
  # bash parts words at = and :, which belong to SCHEME: the word is taken from the line itself.
  local line=${COMP_LINE:0:COMP_POINT}
  local -a words
  read -ra words <<<"$line"
  [[ $line != *[[:space:]] ]] || words+=('')
  local word=${words[${#words[@]} - 1]} typed options='' valued='' place=0 kind=none candidate
  typed=$word
  COMPREPLY=()
  case ${words[1]} in
    reproduce)
      options='--help -h --claims --out -o --jobs -j'
      valued='--claims --out -o --jobs -j'
      _subdivlab_place
      case $place in
        --claims) kind='file' ;;
        --out) kind='folder' ;;
        -o) kind='folder' ;;
        --jobs) kind='none' ;;
        -j) kind='none' ;;
        [0-9]*) kind='claim' ;;
      esac
      ;;
    check)
      options='--help -h --claims --against --jobs -j'
      valued='--claims --against --jobs -j'
      _subdivlab_place
      case $place in
        --claims) kind='file' ;;
        --against) kind='folder' ;;
        --jobs) kind='none' ;;
        -j) kind='none' ;;
        [0-9]*) kind='claim' ;;
      esac
      ;;
    analyze)
      options='--help -h --budget --rounded --json'
      valued='--budget'
      _subdivlab_place
      case $place in
        --budget) kind='none' ;;
        0) kind='scheme' ;;
      esac
      ;;
    optimize)
      options='--help -h --over --objective --norm --polygon --json'
      valued='--over --objective --norm --polygon'
      _subdivlab_place
      case $place in
        --over) kind='none' ;;
        --objective) kind='objective' ;;
        --norm) kind='choice l1 l2 linf' ;;
        --polygon) kind='file' ;;
        0) kind='scheme' ;;
      esac
      ;;
    certify)
      options='--help -h --over --continuity --budget --json'
      valued='--over --continuity --budget'
      _subdivlab_place
      case $place in
        --over) kind='none' ;;
        --continuity) kind='none' ;;
        --budget) kind='none' ;;
        0) kind='scheme' ;;
      esac
      ;;
    plot)
      options='--help -h --over --out -o'
      valued='--over --out -o'
      _subdivlab_place
      case $place in
        --over) kind='none' ;;
        --out) kind='file' ;;
        -o) kind='file' ;;
        0) kind='scheme' ;;
      esac
      ;;
    eigen)
      options='--help -h --valence --over --json'
      valued='--valence --over'
      _subdivlab_place
      case $place in
        --valence) kind='none' ;;
        --over) kind='none' ;;
        0) kind='mesh_scheme' ;;
      esac
      ;;
    refine)
      options='--help -h --scheme --levels -k --out -o --open --grid --open-across --details --retrofit --limit --threads'
      valued='--scheme --levels -k --out -o --open --grid --open-across --details --retrofit --threads'
      _subdivlab_place
      case $place in
        --scheme) kind='any_scheme' ;;
        --levels) kind='none' ;;
        -k) kind='none' ;;
        --out) kind='file' ;;
        -o) kind='file' ;;
        --open) kind='choice clamped reflected' ;;
        --grid) kind='none' ;;
        --open-across) kind='choice clamped reflected' ;;
        --details) kind='file' ;;
        --retrofit) kind='choice direct iteration' ;;
        --threads) kind='none' ;;
        0) kind='any_scheme' ;;
        1) kind='file' ;;
      esac
      ;;
    rings)
      options='--help -h --sigma --out -o --control-points --catmull-clark-step --fill --tessellation --rings-only --json'
      valued='--sigma --out -o --control-points --tessellation'
      _subdivlab_place
      case $place in
        --sigma) kind='none' ;;
        --out) kind='file' ;;
        -o) kind='file' ;;
        --control-points) kind='file' ;;
        --tessellation) kind='none' ;;
        0) kind='file' ;;
      esac
      ;;
    bezier)
      options='--help -h --degree --tolerance --depth -k --out -o --json'
      valued='--degree --tolerance --depth -k --out -o'
      _subdivlab_place
      case $place in
        --degree) kind='none' ;;
        --tolerance) kind='none' ;;
        --depth) kind='none' ;;
        -k) kind='none' ;;
        --out) kind='file' ;;
        -o) kind='file' ;;
        0) kind='file' ;;
      esac
      ;;
    measure)
      options='--help -h --open --scheme --levels -k --against --tolerance --local --json'
      valued='--open --scheme --levels -k --against --tolerance'
      _subdivlab_place
      case $place in
        --open) kind='choice plain clamped reflected' ;;
        --scheme) kind='scheme' ;;
        --levels) kind='none' ;;
        -k) kind='none' ;;
        --against) kind='file' ;;
        --tolerance) kind='none' ;;
        0) kind='file' ;;
      esac
      ;;
    smooth)
      options='--help -h --operators --repeat --open --json --out -o'
      valued='--operators --repeat --open --json --out -o'
      _subdivlab_place
      case $place in
        --operators) kind='none' ;;
        --repeat) kind='none' ;;
        --open) kind='choice drop keep' ;;
        --json) kind='file' ;;
        --out) kind='file' ;;
        -o) kind='file' ;;
        0) kind='file' ;;
      esac
      ;;
    prove)
      options='--help -h --out -o --claims'
      valued='--out -o --claims'
      _subdivlab_place
      case $place in
        --out) kind='folder' ;;
        -o) kind='folder' ;;
        --claims) kind='folder' ;;
        [0-9]*) kind='file' ;;
      esac
      ;;
    verify)
      options='--help -h --print-statement --missing'
      valued=''
      _subdivlab_place
      case $place in
        [0-9]*) kind='file' ;;
      esac
      ;;
    list)
      options='--help -h --json'
      valued=''
      _subdivlab_place
      case $place in
        0) kind='choice schemes claims objectives definitions' ;;
      esac
      ;;
    completion)
      options='--help -h'
      valued=''
      _subdivlab_place
      case $place in
        0) kind='choice bash zsh fish' ;;
      esac
      ;;
    manual)
      options='--help -h'
      valued=''
      _subdivlab_place
      case $place in
      esac
      ;;
  esac
  if [[ ${#words[@]} -le 2 ]]; then
    kind='choice reproduce check analyze optimize certify plot eigen refine rings bezier measure smooth prove verify list completion manual --help --version'
  elif [[ $word == -* && $place =~ ^[0-9]+$ ]]; then
    kind="choice $options"
  fi
  # shellcheck disable=SC2046,SC2086
  case $kind in
    choice*) _subdivlab_words ${kind#choice} ;;
    file)
      compopt -o filenames 2>/dev/null
      while IFS= read -r candidate; do COMPREPLY+=("$candidate"); done < <(compgen -f -- "$word")
      ;;
    folder)
      compopt -o filenames 2>/dev/null
      while IFS= read -r candidate; do COMPREPLY+=("$candidate"); done < <(compgen -d -- "$word")
      ;;
    scheme) _subdivlab_schemes jspline:s= jspline:a= bspline:degree= lane-riesenfeld:degree= four-point four-point:w= dyn-floater-hormann dyn-floater-hormann:w= deslauriers-dubuc deslauriers-dubuc:points= ;;
    mesh_scheme) _subdivlab_schemes catmull-clark kobbelt jspline-mesh:s= jspline-mesh-literal:s= loop loop-1987 butterfly adjustable-speed:sigma= ;;
    any_scheme)
      _subdivlab_schemes jspline:s= jspline:a= bspline:degree= lane-riesenfeld:degree= four-point four-point:w= dyn-floater-hormann dyn-floater-hormann:w= deslauriers-dubuc deslauriers-dubuc:points= catmull-clark kobbelt jspline-mesh:s= jspline-mesh-literal:s= loop loop-1987 butterfly adjustable-speed:sigma=
      # Behind --scheme, the first word is a file.
      while IFS= read -r candidate; do COMPREPLY+=("$candidate"); done < <(compgen -f -X '*.json' -- "$word")
      ;;
    objective) _subdivlab_words area difference-norm difference-norm:continuity= edge edge-distance fit-bspline fit-bspline:continuum fit-bspline:degree= fit-bspline:level= polygon-distance popping popping:level= vertex vertex-distance ;;
    claim) _subdivlab_words $(_subdivlab_claims) ;;
  esac
  # What bash has parted off must not stand in the answers.
  local parted=''
  [[ $COMP_WORDBREAKS != *=* || $typed != *=* ]] || parted=${typed%"${typed##*=}"}
  if [[ $COMP_WORDBREAKS == *:* && $typed == *:* ]]; then
    local until_colon=${typed%"${typed##*:}"}
    ((${#until_colon} <= ${#parted})) || parted=$until_colon
  fi
  parted=${parted#"${typed%"$word"}"}
  COMPREPLY=("${COMPREPLY[@]#"$parted"}")
}

complete -F _subdivlab subdivlab
