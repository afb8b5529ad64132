package org.starl.apps.lightpaint;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.starl.apps.lightpaint.logic.Ink;
import org.starl.apps.lightpaint.logic.Line;
import org.starl.apps.lightpaint.logic.Polyline;
import org.starl.geometry.Point;
import org.starl.input.BadInput;

/** Drawings of the original StarL: the ends of lines, in pairs. */
class WptDrawingTest {

  @Test
  void twoEndsMakeALineInTheColourOfTheAngleColumn() {
    String text =
        "WAY,10,20,16744192,1-B_5\n// a comment\nWAY,0,0,255,0-A_2\nWAY,30,40,16744192,1-A_5\n";
    List<Line> lines = WptDrawing.read("a.wpt", text + "WAY,9,9,255,0-B_2\n", 4);
    assertThat(lines)
        .containsExactly(
            new Line(new Polyline(List.of(new Point(0, 0), new Point(9, 9))), new Ink(255, 8)),
            new Line(
                new Polyline(List.of(new Point(30, 40), new Point(10, 20))),
                new Ink(0xff7f00, 20)));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = ';',
      value = {
        "WAY,1,1,0,home|; a.wpt:1: 'home' does not name the end of a line: expected WAY,x,y,colour,i-A_w",
        "//|WAY,1,1,0,0-A_5|; a.wpt:2: '0-A_5' has no 0-B_5: expected",
        "WAY,1,1,0,0-A_5|WAY,1,1,0,0-A_5|; a.wpt:2: '0-A_5' is there twice",
        "WAY,1,1,0,0-A_5|WAY,9,1,7,0-B_5|; a.wpt:2: '0-B_5' has another colour than 0-A_5",
        "WAY,1,1,-1,0-A_5|WAY,9,1,-1,0-B_5|; a.wpt:1: '0-A_5' has a third column that is not a colour",
        "WAY,1,1,0,0-A_0|WAY,9,1,0,0-B_0|; a.wpt:1: '0-A_0' has no width",
        "WAY,1|; a.wpt:1: 'WAY,1': expected WAY,x,y,angle,name"
      })
  void theErrorNamesTheLine(String lines, String expected) {
    assertThatThrownBy(() -> WptDrawing.read("a.wpt", lines.replace('|', '\n'), 5))
        .isInstanceOf(BadInput.class)
        .hasMessageStartingWith(expected.strip());
  }
}
