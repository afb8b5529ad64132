package org.starl.cli.command;

import picocli.CommandLine.Help.Ansi;

/** Colour on a terminal, unless NO_COLOR is set: for what a person must not overlook. */
public final class Colour {

  private Colour() {}

  /** Text of what went wrong: bold and red. */
  public static String bad(String text) {
    return Ansi.AUTO.enabled() ? "\u001b[1;31m" + text + "\u001b[0m" : text;
  }
}
