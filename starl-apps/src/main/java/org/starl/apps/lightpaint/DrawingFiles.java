package org.starl.apps.lightpaint;

import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import org.starl.apps.lightpaint.logic.Line;
import org.starl.apps.lightpaint.view.SvgDrawing;
import org.starl.input.BadInput;
import org.starl.input.TextFile;

/** Reads drawings from files, by their suffix. */
final class DrawingFiles {

  private static final String EXPECTED = "expected a drawing, NAME.svg or NAME.wpt";

  private DrawingFiles() {}

  /**
   * The lines of a drawing, in mm.
   *
   * @param mmPerUnit scale of an SVG; of a {@code .wpt} drawing, of its lines' widths only
   * @param flatnessMm maximum distance of a curve from the straight lines that replace it
   * @throws BadInput if the file cannot be read or has no line to paint
   */
  static List<Line> read(Path path, double mmPerUnit, double flatnessMm) {
    String file = path.toString();
    boolean isSvg = file.toLowerCase(Locale.ROOT).endsWith(".svg");
    if (!isSvg && !file.toLowerCase(Locale.ROOT).endsWith(".wpt")) {
      throw new BadInput(file + ": " + EXPECTED);
    }
    byte[] bytes = TextFile.bytes(path, EXPECTED);
    List<Line> lines =
        isSvg
            ? SvgDrawing.read(file, bytes, mmPerUnit, flatnessMm)
            : WptDrawing.read(file, TextFile.decode(file, bytes, EXPECTED), mmPerUnit);
    if (lines.isEmpty()) {
      throw new BadInput(file + ": no line has a stroke: expected at least one line to paint");
    }
    return lines;
  }
}
