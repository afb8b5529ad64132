package org.starl.build;

/**
 * What one module needs of another module or of a library.
 *
 * @param module which module needs it
 * @param needed group and name, such as {@code org.jspecify:jspecify}; what is no jar has {@code
 *     @} and its type behind
 * @param version of a library; the project's own for a module
 * @param scope compile, provided or test, as Maven calls them
 */
record Dependency(String module, String needed, String version, String scope) {}
