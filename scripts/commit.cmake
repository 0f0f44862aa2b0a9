# Writes a header with the commit that is built, `-dirty` if files were changed since.
execute_process(COMMAND git -C ${SOURCE} describe --always --abbrev=12 --exclude=* --dirty
                OUTPUT_VARIABLE COMMIT OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
file(CONFIGURE OUTPUT ${OUT} CONTENT "#define LAMINA_COMMIT \"@COMMIT@\"\n" @ONLY)
