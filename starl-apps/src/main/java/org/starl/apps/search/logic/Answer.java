package org.starl.apps.search.logic;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.starl.comms.WireFormatException;
import org.starl.comms.WireReader;
import org.starl.comms.WireWriter;

/** How a search ends. */
public sealed interface Answer {

  /**
   * A thing was seen.
   *
   * @param xMm where it is, by the finder's sensor
   * @param finder the robot's name
   */
  record Found(String thing, int xMm, int yMm, String finder) implements Answer {
    @Override
    public String toString() {
      return "found " + thing + " at " + xMm + "," + yMm + " by " + finder;
    }
  }

  /** Every room was searched in full, and nothing is there. */
  record Nothing() implements Answer {
    @Override
    public String toString() {
      return NOTHING;
    }
  }

  /**
   * Nothing was seen, and these rooms could not be searched in full.
   *
   * @param rooms by their names, in order
   */
  record GaveUp(List<String> rooms) implements Answer {
    public GaveUp {
      rooms = List.copyOf(rooms);
    }

    @Override
    public String toString() {
      return GAVE_UP + String.join(" ", rooms);
    }
  }

  String NOTHING = "nothing there";
  String FOUND = "found ";
  String GAVE_UP = "gave up, could not search ";

  int MAX_BYTES = 512;

  /** The bytes of an answer, to agree on. */
  static byte[] toBytes(Answer answer) {
    byte[] buffer = new byte[MAX_BYTES];
    WireWriter out = new WireWriter(buffer);
    write(answer, out);
    return Arrays.copyOf(buffer, out.length());
  }

  /** @throws WireFormatException if it is none */
  static Answer of(byte[] bytes) {
    return read(new WireReader(bytes));
  }

  static void write(Answer answer, WireWriter out) {
    switch (answer) {
      case Found found -> {
        out.u8(1);
        out.string(found.thing());
        out.i32(found.xMm());
        out.i32(found.yMm());
        out.string(found.finder());
      }
      case Nothing nothing -> out.u8(2);
      case GaveUp gaveUp -> {
        out.u8(3);
        out.u8(gaveUp.rooms().size());
        gaveUp.rooms().forEach(out::string);
      }
    }
  }

  static Answer read(WireReader in) {
    int kind = in.u8();
    switch (kind) {
      case 1 -> {
        String thing = in.string();
        int xMm = in.i32();
        int yMm = in.i32();
        return new Found(thing, xMm, yMm, in.string());
      }
      case 2 -> {
        return new Nothing();
      }
      case 3 -> {
        int count = in.u8();
        List<String> rooms = new ArrayList<>();
        for (int i = 0; i < count; i++) {
          rooms.add(in.string());
        }
        return new GaveUp(rooms);
      }
      default -> throw new WireFormatException("answer of kind " + kind);
    }
  }
}
