package org.starl.sim.world;

import java.nio.file.Path;
import java.util.BitSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.starl.input.BadInput;
import org.starl.input.TextFile;

/**
 * Reads the grid maps of the public path-finding benchmarks (N. Sturtevant, "Benchmarks for
 * grid-based pathfinding", 2012; movingai.com):
 *
 * <pre>
 * type octile
 * height 32
 * width 32
 * map
 * @@@.@.@@@.......   as many rows of as many cells
 * </pre>
 *
 * A cell {@code .}, {@code G} or {@code S} (swamp) is free; {@code @ O T W} (out of bounds, trees, water) are
 * blocked. The type may be missing, and the width may come before the height; blank lines, and comments
 * after {@code #}, {@code //}, {@code %} or {@code ;}, are skipped before the rows. LF and CRLF line ends, white
 * space at ends of lines, and trailing blank lines are accepted. Any other text causes a {@link BadInput} with file, line
 * and the expected text.
 */
public final class GridMaps {

  private static final int MAX_SIDE = 2_048;
  private static final Pattern SKIPPED = Pattern.compile("|(#|//|%|;).*");
  private static final Pattern SIZE = Pattern.compile("(height|width)\\s+([0-9]{1,6})");
  private static final String FREE = ".GS";
  private static final String BLOCKED = "@OTW";

  private final String file;
  private final String[] lines;

  private GridMaps(String file, String text) {
    this.file = file;
    this.lines = text.split("\r\n|\r|\n", -1);
  }

  /** Whether a text begins as a map in this format does. */
  public static boolean isMap(String text) {
    GridMaps maps = new GridMaps("", text);
    return maps.line(maps.after(0)).matches("(type|height|width)\\s.*");
  }

  /**
   * Reads a file.
   *
   * @throws BadInput if the file is missing, not text, or not a map in this format
   */
  public static GridMap read(Path path) {
    return parse(path.toString(), TextFile.read(path, "expected a grid map: type octile, ..."));
  }

  /**
   * Reads a file's text.
   *
   * @param file the file's name, for errors
   */
  public static GridMap parse(String file, String text) {
    return new GridMaps(file, text).map();
  }

  private GridMap map() {
    int heightLine = 0;
    int widthLine = 0;
    int number = after(0);
    if (line(number).startsWith("type")) {
      require(number, "type octile");
      number = after(number);
    }
    for (int i = 0; i < 2; i++) {
      boolean isWidth = widthLine == 0 && (heightLine > 0 || line(number).startsWith("width"));
      size(number, isWidth ? "width" : "height");
      widthLine = isWidth ? number : widthLine;
      heightLine = isWidth ? heightLine : number;
      number = after(number);
    }
    require(number, "map");
    int height = size(heightLine, "height");
    int width = size(widthLine, "width");
    BitSet blocked = new BitSet(width * height);
    for (int i = 1; i <= height; i++) {
      row(number + i, width, widthLine, height - i, blocked);
    }
    for (int next = number + height + 1; next <= lines.length; next++) {
      if (!line(next).isEmpty()) {
        throw broken(next, "only the " + height + " rows of line " + heightLine);
      }
    }
    return new GridMap(width, height, blocked);
  }

  /** The header's next line, or that after the last. */
  private int after(int number) {
    int next = number + 1;
    while (next <= lines.length && SKIPPED.matcher(line(next)).matches()) {
      next++;
    }
    return next;
  }

  private void require(int number, String expected) {
    if (!line(number).replaceAll("\\s+", " ").equals(expected)) {
      throw broken(number, "'" + expected + "'");
    }
  }

  private int size(int number, String key) {
    Matcher matcher = SIZE.matcher(line(number));
    int size =
        matcher.matches() && matcher.group(1).equals(key) ? Integer.parseInt(matcher.group(2)) : 0;
    if (size < 1 || size > MAX_SIDE) {
      throw broken(number, "'" + key + " N' with N from 1 to " + MAX_SIDE);
    }
    return size;
  }

  private void row(int number, int width, int widthLine, int row, BitSet blocked) {
    String cells = number <= lines.length ? lines[number - 1] : "";
    if (cells.length() > width) {
      cells = cells.stripTrailing();
    }
    if (cells.length() != width) {
      throw broken(number, width + " cells as in line " + widthLine + ", not " + cells.length());
    }
    for (int column = 0; column < width; column++) {
      char cell = cells.charAt(column);
      if (BLOCKED.indexOf(cell) >= 0) {
        blocked.set(row * width + column);
      } else if (FREE.indexOf(cell) < 0) {
        throw broken(
            number,
            "cells . G S (free) or @ O T W (blocked), not '"
                + cell
                + "' in column "
                + (column + 1));
      }
    }
  }

  private String line(int number) {
    return number <= lines.length ? lines[number - 1].strip() : "";
  }

  private BadInput broken(int number, String expected) {
    String what = number <= lines.length ? BadInput.quote(line(number)) : "the file ends";
    return new BadInput(file + ":" + number + ": " + what + ": expected " + expected);
  }
}
