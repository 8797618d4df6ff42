# Tab completion of pabd for fish: into ~/.config/fish/completions, as pabd.fish.
function __pabd_offers
    set -l before (commandline -opc)
    set -l current (commandline -ct)
    set -l program $before[1]
    set -e before[1]
    for line in ($program --complete $before "$current" 2>/dev/null)
        switch $line
            case \tfiles
                __fish_complete_path "$current"
            case \tfolders
                __fish_complete_directories "$current"
            case '*'
                echo $line
        end
    end
end
complete -c pabd -f -k -a '(__pabd_offers)'
