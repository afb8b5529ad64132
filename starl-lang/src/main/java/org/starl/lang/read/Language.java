package org.starl.lang.read;

import java.util.List;

/** Names that the language defines, besides the words of its grammar. */
final class Language {

  /** Functions of any type of option or list. */
  static final List<String> WORDS =
      List.of("some", "the", "head", "tail", "length", "card", "elements", "distinct");

  private Language() {}
}
