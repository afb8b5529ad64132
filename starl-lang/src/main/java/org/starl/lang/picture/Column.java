package org.starl.lang.picture;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Boxes in one column, in the order of the source, and the arrows between them. An arrow to the next
 * box is a straight line. Each other one leaves its box at the side, runs along the column in a lane
 * of its own, and enters the other box at the side: upward on the left, downward on the right. Its text
 * stands on its way from the box to the lane. So no line crosses a text.
 */
final class Column {

  private static final int MARGIN = 16;
  private static final int LANE = 14;
  private static final int PAD = 6;
  private static final int LEAST_HEIGHT = 34;
  private static final int ENTRY = 16;

  private final List<String> names;
  private final List<Arrow> arrows;
  private final int boxWidth;
  // Where each arrow leaves and enters its boxes, counted from the top of the box.
  private final Map<Arrow, Integer> exits = new LinkedHashMap<>();
  private final Map<Arrow, Integer> entries = new LinkedHashMap<>();
  private final Map<Arrow, Integer> lanes = new LinkedHashMap<>();
  private final int[] tops;
  private final int[] heights;

  /**
   * @param names of the boxes
   */
  Column(List<String> names, List<Arrow> arrows) {
    this.names = names;
    this.arrows = arrows;
    boxWidth = Svg.widthOf(names) + 4 * PAD;
    tops = new int[names.size()];
    heights = new int[names.size()];
    int y = MARGIN + 2 * LANE;
    for (int box = 0; box < names.size(); box++) {
      tops[box] = y;
      heights[box] = Math.max(LEAST_HEIGHT, Math.max(ports(box, true), ports(box, false)));
      y += heights[box] + gapBelow(box);
    }
    assignLanes(true);
    assignLanes(false);
  }

  /** Gives the arrows of one side of a box their heights; returns the height of all. */
  private int ports(int box, boolean isLeft) {
    int y = PAD;
    for (Arrow arrow : arrows) {
      boolean isHere = !arrow.isStraight() && arrow.isLeft() == isLeft;
      if (isHere && arrow.to() == box) {
        y += ENTRY;
        entries.put(arrow, y - ENTRY / 2);
      }
      if (isHere && arrow.from() == box) {
        y += arrow.lines() * Svg.LINE + PAD;
        exits.put(arrow, y);
        y += PAD;
      }
    }
    return y + PAD;
  }

  /** Room for the texts of the straight arrows. */
  private int gapBelow(int box) {
    int lines = straight(box).stream().mapToInt(arrow -> arrow.lines() * Svg.LINE + PAD).sum();
    return Math.max(2 * LANE, lines + 2 * LANE);
  }

  private List<Arrow> straight(int box) {
    return arrows.stream().filter(arrow -> arrow.isStraight() && arrow.from() == box).toList();
  }

  /** Short arrows run near the boxes; no two in one lane are beside each other. */
  private void assignLanes(boolean isLeft) {
    List<Arrow> here = new ArrayList<>(arrows);
    here.removeIf(arrow -> arrow.isStraight() || arrow.isLeft() != isLeft);
    here.sort(Comparator.comparingInt(arrow -> arrow.bottom() - arrow.top()));
    for (Arrow arrow : here) {
      int lane = 0;
      while (isTaken(lane, arrow)) {
        lane++;
      }
      lanes.put(arrow, lane);
    }
  }

  private boolean isTaken(int lane, Arrow arrow) {
    return lanes.entrySet().stream()
        .anyMatch(other ->
            other.getValue() == lane
                && other.getKey().isLeft() == arrow.isLeft()
                && other.getKey().top() <= arrow.bottom()
                && arrow.top() <= other.getKey().bottom());
  }

  String svg(String title) {
    int x = MARGIN + laneRoom(true) + textRoom(true);
    int middle = x + boxWidth / 2;
    Svg svg = new Svg().dot(middle, MARGIN).path("M" + middle + " " + MARGIN + "V" + (tops[0] - 1));
    for (int box = 0; box < names.size(); box++) {
      int number = box;
      boolean isLast = arrows.stream().noneMatch(arrow -> arrow.from() == number);
      svg.box(x, tops[box], boxWidth, heights[box], isLast);
      svg.name(middle, tops[box] + heights[box] / 2 + 4, names.get(box));
      drawStraight(svg, box, middle);
    }
    int right = x + boxWidth;
    for (Map.Entry<Arrow, Integer> lane : lanes.entrySet()) {
      boolean isLeft = lane.getKey().isLeft();
      int out = LANE * lane.getValue() + textRoom(isLeft) + LANE;
      draw(svg, lane.getKey(), isLeft ? x : right, isLeft ? x - out : right + out);
    }
    int width = right + textRoom(false) + laneRoom(false) + MARGIN;
    int last = names.size() - 1;
    return svg.file(title, width, tops[last] + heights[last] + MARGIN);
  }

  private void drawStraight(Svg svg, int box, int middle) {
    int y = tops[box] + heights[box];
    List<Arrow> here = straight(box);
    if (!here.isEmpty()) {
      svg.path("M" + middle + " " + y + "V" + (tops[box + 1] - 1));
    }
    int at = y + Svg.LINE + PAD;
    for (Arrow arrow : here) {
      svg.label(middle + 2 * PAD, at, arrow);
      at += arrow.lines() * Svg.LINE + PAD;
    }
  }

  /** Along the lane at {@code lane}, from and to the side of the boxes at {@code side}. */
  private void draw(Svg svg, Arrow arrow, int side, int lane) {
    int from = tops[arrow.from()] + exits.getOrDefault(arrow, 0);
    int to = tops[arrow.to()] + entries.getOrDefault(arrow, 0);
    int tip = arrow.isLeft() ? side - 1 : side + 1;
    svg.path("M" + side + " " + from + "H" + lane + "V" + to + "H" + tip);
    int text = arrow.isLeft() ? side - textRoom(true) : side + PAD;
    svg.label(text, from - PAD - (arrow.lines() - 1) * Svg.LINE, arrow);
  }

  /** Between the boxes and the lanes. */
  private int textRoom(boolean isLeft) {
    return arrows.stream()
        .filter(arrow -> arrow.isLeft() == isLeft)
        .mapToInt(
            arrow -> textWidth(arrow) + 2 * PAD + (arrow.isStraight() ? PAD - boxWidth / 2 : 0))
        .reduce(0, Math::max);
  }

  private int laneRoom(boolean isLeft) {
    return lanes.entrySet().stream()
        .filter(each -> each.getKey().isLeft() == isLeft)
        .mapToInt(each -> LANE * (each.getValue() + 1))
        .max()
        .orElse(0);
  }

  private static int textWidth(Arrow arrow) {
    return Math.max(Svg.widthOf(arrow.guard()), Svg.widthOf(arrow.effect()));
  }
}
