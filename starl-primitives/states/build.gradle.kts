plugins {
    `java-library`
    id("maven-publish")
}

description = "All states of a protocol's code: not for robots"

dependencies {
    api(project(":starl-core"))
    api(project(":starl-primitives"))
    api(libs.jspecify)
    testImplementation(libs.junit.jupiter)
    testImplementation(libs.assertj.core)
    testImplementation(libs.jqwik)
    testRuntimeOnly(libs.junit.platform.launcher)
}
