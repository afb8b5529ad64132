plugins {
    `java-library`
}

description = "Platform and physical layers, simulated"

dependencies {
    api(project(":starl-core"))
    api(libs.jspecify)
    testImplementation(libs.junit.jupiter)
    testImplementation(libs.assertj.core)
    testImplementation(libs.jqwik)
    testRuntimeOnly(libs.junit.platform.launcher)
}
