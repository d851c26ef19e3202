# tr.sh OUT FILES
