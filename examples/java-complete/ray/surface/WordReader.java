package ray.surface;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;

/** Reads a text file word by word. Large meshes have a million numbers, so none becomes a String if it is simple. */
final class WordReader {

    /** Whole numbers up to 2^53 and powers of ten up to 10^22 are exact in double precision. */
    private static final int MOST_DIGITS = 15;
    private static final double[] POWERS_OF_TEN = new double[MOST_DIGITS + 1];

    static {
        POWERS_OF_TEN[0] = 1;
        for (int i = 1; i <= MOST_DIGITS; i++) {
            POWERS_OF_TEN[i] = 10 * POWERS_OF_TEN[i - 1];
        }
    }

    private final File file;
    private final byte[] text;
    private int at;
    private int line = 1;
    private int wordStart;
    private int wordEnd;

    WordReader(File file) throws IOException {
        this.file = file;
        if (!file.isFile()) {
            throw new IOException(file + ": there is no such mesh file");
        }
        text = Files.readAllBytes(file.toPath());
    }

    /** The next word, or null at the end of the file. */
    String next() {
        return find() ? word() : null;
    }

    int nextCount() throws IOException {
        String word = next();
        try {
            int count = Integer.parseInt(String.valueOf(word));
            if (count >= 0) {
                return count;
            }
        } catch (NumberFormatException e) {
            // the message below says what is wrong
        }
        throw error("expected a whole number from 0 on, not " + word);
    }

    /** The number in single precision. */
    double nextFloat() throws IOException {
        if (!find()) {
            throw error("expected a number, not the end of the file");
        }
        double simple = simpleNumber();
        if (!Double.isNaN(simple) && !isBetweenFloats(simple)) {
            return (float) simple;
        }
        try {
            float value = Float.parseFloat(word());
            if (!Float.isNaN(value) && !Float.isInfinite(value)) {
                return value;
            }
        } catch (NumberFormatException e) {
            // the message below says what is wrong
        }
        throw error("expected a number, not " + word());
    }

    /** A length for a list; a file that is too short for it is found out before the memory is asked for. */
    int checkedLength(int each, int count) throws IOException {
        long length = (long) each * count;
        if (length > text.length) {
            throw error("the file is too short for " + count + " of them");
        }
        return (int) length;
    }

    IOException error(String what) {
        return new IOException(file + ":" + line + ": " + what);
    }

    /** Digits with at most one point, as a double with one rounding; NaN if the word is anything else. */
    private double simpleNumber() {
        boolean negative = text[wordStart] == '-';
        long digits = 0;
        int count = 0;
        int decimals = -1;
        for (int i = negative ? wordStart + 1 : wordStart; i < wordEnd; i++) {
            if (text[i] == '.' && decimals < 0) {
                decimals = 0;
            } else if (text[i] >= '0' && text[i] <= '9' && count < MOST_DIGITS) {
                digits = 10 * digits + text[i] - '0';
                count++;
                decimals = decimals < 0 ? decimals : decimals + 1;
            } else {
                return Double.NaN;
            }
        }
        double size = count == 0 ? Double.NaN : digits / POWERS_OF_TEN[Math.max(0, decimals)];
        return negative ? -size : size;
    }

    /** Whether it lies half way between two floats, where rounding twice is not the same as rounding once. */
    private static boolean isBetweenFloats(double value) {
        return (Double.doubleToRawLongBits(value) & 0x1fffffffL) == 0x10000000L;
    }

    private boolean find() {
        at = wordEnd;
        while (at < text.length && text[at] <= ' ') {
            if (text[at] == '\n') {
                line++;
            }
            at++;
        }
        wordStart = at;
        while (at < text.length && text[at] > ' ') {
            at++;
        }
        wordEnd = at;
        return wordStart < wordEnd;
    }

    private String word() {
        return new String(text, wordStart, wordEnd - wordStart, StandardCharsets.ISO_8859_1);
    }
}
