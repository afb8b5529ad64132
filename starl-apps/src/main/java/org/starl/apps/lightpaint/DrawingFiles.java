package org.starl.apps.lightpaint;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import org.starl.apps.lightpaint.logic.Line;
import org.starl.apps.lightpaint.view.SvgDrawing;
import org.starl.input.BadInput;
import org.starl.input.TextFile;

/** Reads drawings from files, by their suffix. */
final class DrawingFiles {

  /** The default drawing: a house, its path and the sun; one unit is 1 mm. */
  private static final String HOUSE =
      """
      <svg xmlns='http://www.w3.org/2000/svg' width='3600' height='2300'>
      <g fill='none' stroke-width='25'>
      <polygon stroke='#3366cc' points='400,2000 2000,2000 2000,900 400,900'/>
      <polyline stroke='#cc3322' points='250,900 1200,150 2150,900'/>
      <polyline stroke='#8a5a2b' points='1350,2000 1350,1350 1750,1350 1750,2000'/>
      <polygon stroke='#3366cc' points='650,1600 1050,1600 1050,1200 650,1200'/>
      <polyline stroke='#2e8b57' points='2000,2000 3400,2000'/>
      <g stroke='#f5a800'>
      <polygon points='3150,400 3140,322 3110,250 3062,188 3000,140 2928,110 2850,100 2772,110
        2700,140 2638,188 2590,250 2560,322 2550,400 2560,478 2590,550 2638,612 2700,660 2772,690
        2850,700 2928,690 3000,660 3062,612 3110,550 3140,478'/>
      <polyline points='2450,400 2200,400'/>
      <polyline points='2567,683 2390,860'/>
      <polyline points='2850,800 2850,1050'/>
      <polyline points='3133,683 3310,860'/>
      </g></g></svg>
      """;

  private static final String EXPECTED = "expected a drawing, NAME.svg or NAME.wpt";

  private DrawingFiles() {}

  static List<Line> house(double flatnessMm) {
    return SvgDrawing.read("house.svg", HOUSE.getBytes(StandardCharsets.UTF_8), 1, flatnessMm);
  }

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
      throw new BadInput(file + ": no line has a stroke: expected something to paint");
    }
    return lines;
  }
}
