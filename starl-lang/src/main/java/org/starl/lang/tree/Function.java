package org.starl.lang.tree;

import java.util.List;
import java.util.Optional;

/**
 * A total function.
 *
 * @param measure what becomes smaller with each recursive call
 * @param comment the lines of comment before it, without their slashes
 */
public record Function(
    Signature signature, Expr body, Optional<Expr> measure, List<String> comment, Pos pos) {}
