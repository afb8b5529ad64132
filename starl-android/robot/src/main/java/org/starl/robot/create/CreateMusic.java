package org.starl.robot.create;

import static org.starl.time.Time.NS_PER_S;

/** The songs of a simulated Create: their lengths, and the one that plays. */
final class CreateMusic {

  private static final long NS_PER_LENGTH = NS_PER_S / 64;
  private static final int MAX_NOTES = 16;

  /** 0 for none. */
  private final long[] lastsNs;

  private int number;
  private long endNs = Long.MIN_VALUE;

  CreateMusic(CreateModel model) {
    lastsNs = new long[model.songs()];
  }

  /** Stores the data of opcode 140; false if it is not a song. */
  boolean store(byte[] data, int length) {
    int song = data[0] & 0xFF;
    int notes = data[1] & 0xFF;
    if (song >= lastsNs.length || notes < 1 || notes > MAX_NOTES) {
      return false;
    }
    long sum = 0;
    for (int at = 3; at < length; at += 2) {
      sum += data[at] & 0xFF;
    }
    lastsNs[song] = sum * NS_PER_LENGTH;
    return true;
  }

  /** Plays a stored song, unless one is playing. */
  boolean play(int song, long atNs) {
    if (song >= lastsNs.length || lastsNs[song] == 0 || playing(atNs) >= 0) {
      return false;
    }
    number = song;
    endNs = atNs + lastsNs[song];
    return true;
  }

  /** The song that plays; -1 for none. */
  int playing(long atNs) {
    return atNs < endNs ? number : -1;
  }

  /** The song that was played last, 0 at first. */
  int number() {
    return number;
  }
}
