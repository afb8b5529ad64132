package org.starl.build;

import java.util.List;

/**
 * One text file of the project.
 *
 * @param path from the project's root, with slashes
 */
record SourceFile(String path, String text) {

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

  /** The lines with the contents of comments and of string literals blanked out. */
  List<String> codeLines() {
    return JavaText.codeOf(text).lines().toList();
  }
}
