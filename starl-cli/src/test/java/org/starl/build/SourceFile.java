package org.starl.build;

import java.util.List;

/** One text file of the project. */
final class SourceFile {

  private final String path;
  private final String text;
  private String code = "";

  /**
   * @param path from the project's root, with slashes
   */
  SourceFile(String path, String text) {
    this.path = path;
    this.text = text;
  }

  String path() {
    return path;
  }

  String text() {
    return text;
  }

  List<String> lines() {
    return text.lines().toList();
  }

  boolean isJava() {
    return path.endsWith(".java");
  }

  /** Java or Kotlin. */
  boolean isCode() {
    return isJava() || path.endsWith(".kt");
  }

  /** Code that is shipped, not a test. */
  boolean isMain() {
    return isCode() && path.contains("/src/main/");
  }

  /** The text with the contents of comments and of string literals blanked out. */
  String code() {
    if (code.isEmpty()) {
      code = JavaText.codeOf(text); // once: each rule asks
    }
    return code;
  }
}
