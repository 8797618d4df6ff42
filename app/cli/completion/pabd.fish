# Tab completion of pabd for fish: into ~/.config/fish/completions, as pabd.fish.
function __pabd_offers
    set -l words (commandline -opc) (commandline -ct)
    for line in ($words[1] --complete $words[2..-1] 2>/dev/null)
        switch $line
            case \tfiles
                __fish_complete_path (commandline -ct)
            case \tfolders
                __fish_complete_directories (commandline -ct)
            case '*'
                echo $line
        end
    end
end
complete -c pabd -f -k -a '(__pabd_offers)'
